/// mjcf_joint_tendons.h - tendons over several joints, and spatial ones, as sliders that stand at their lengths (multibody/joint_tendon.h,
/// multibody/spatial_tendon.h).
///
/// L = sum c_i q_i, with the positions of the file (`ref` counts), or the length of the path. Stiffness, damping, frictionloss, armature and range are those of the
/// slider; without `springlength` its spring is slack where all joints stand at their `springref`.
/// Source: MuJoCo documentation, XML reference, "tendon", "fixed" and "spatial".
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "murosimf/robot_formats/mjcf/mjcf_actuator.h"
#include "murosimf/robot_formats/mjcf/mjcf_tendons.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot_formats::mjcf {

/// Joints of the robot with the sums of their coefficients, without zeros; empty if one of them is none of the robot's.
[[nodiscard]] std::vector<std::pair<std::string, double>> joints_of_tendon(const files::XmlElement& tendon,
                                                                           const MjcfNames& names);

/// Once the bodies are read: adds to `description` the tendons with sliders that do something. Those with a ball are taken out of
/// `tendons`.  Throws SetupError for impossible numbers, and paths around what is neither a sphere nor a cylinder.
void add_joint_tendons(std::map<std::string, MjcfTendon>& tendons, const MjcfDefaults& defaults,
                       const MjcfCompiler& compiler, const MjcfActuators& actuators,
                       robot_formats::RobotDescription& description);

}  // namespace murosimf::robot_formats::mjcf
