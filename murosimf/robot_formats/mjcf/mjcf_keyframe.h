/// mjcf_keyframe.h - keys of an MJCF file: named postures at which a robot can start (scene key `keyframe`).
///
/// `qpos` has the positions of all joints of the file in its order: of a floating one place and attitude (x y z, w x y z), of a ball a
/// quaternion, of others one number each. Numbers of objects beside the robot are skipped. `ctrl` has the controls in the order
/// of the actuators. A key without a name is called key1, key2, ... by its number in the file.
/// Source: MuJoCo documentation, XML reference, "keyframe".
#pragma once

#include "murosimf/robot_formats/mjcf/mjcf_actuator.h"
#include "murosimf/robot_formats/mjcf/mjcf_context.h"
#include "murosimf/robot_formats/mjcf/mjcf_trees.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot_formats::mjcf {

/// Fills keyframes of `description`, after its bodies are read. Throws SetupError for numbers that do not match the file.
void read_keyframes(const files::XmlElement& root, const MjcfTrees& trees, const MjcfContext& context,
                    const MjcfActuators& actuators, robot_formats::RobotDescription& description);

}  // namespace murosimf::robot_formats::mjcf
