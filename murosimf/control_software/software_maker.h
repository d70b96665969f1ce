/// software_maker.h - type of factories for the control software of a robot, without its dependencies.
#pragma once

#include <functional>
#include <memory>
#include <string>

namespace murosimf {
class Setup;
}

namespace murosimf::control_software {

class ControlSoftware;  // control_software.h
class RobotPort;        // robot_port.h

/// Receives an output line of the software (murosimf_robot::say).
using SayLine = std::function<void(const std::string& line)>;

using SoftwareMaker = std::function<std::unique_ptr<ControlSoftware>(Setup&, RobotPort&, const SayLine&)>;

}  // namespace murosimf::control_software
