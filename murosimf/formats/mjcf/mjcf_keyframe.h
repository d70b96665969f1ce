/// mjcf_keyframe.h - keys of an MJCF file: postures with names, at which a robot can start (scene key `keyframe`).
///
/// `qpos` has place and attitude of the base (x y z, w x y z), then the positions of the joints in the order of the file; `ctrl` the
/// controls in the order of the actuators. A key without a name is called key1, key2, ... by its number in the file.
/// Source: MuJoCo documentation, XML reference, "keyframe".
#pragma once

#include "murosimf/description/robot_description.h"
#include "murosimf/formats/mjcf/mjcf_actuator.h"

namespace murosimf::formats::mjcf {

/// Fills keyframes of `description`, whose bodies are read already. Throws SetupError for numbers that do not fit to it; in a file with
/// other bodies besides the robot keys are a line in `unused`, since their numbers are not the robot's alone.
void read_keyframes(const files::XmlElement& root, const MjcfActuators& actuators, bool alone,
                    description::RobotDescription& description);

}  // namespace murosimf::formats::mjcf
