/// software_maker.h - how the control software of a robot is made, without what that takes.
#pragma once

#include <functional>
#include <memory>
#include <string>

namespace murosimf {
class Setup;
}

namespace murosimf::connect {

class ControlSoftware;  // control_software.h
class RobotPort;        // robot_port.h

/// A line that software says (murosimf_robot::say).
using SayLine = std::function<void(const std::string& line)>;

using SoftwareMaker = std::function<std::unique_ptr<ControlSoftware>(Setup&, RobotPort&, const SayLine&)>;

}  // namespace murosimf::connect
