/// mjcf_tendons.h - fixed tendons with a length that depends on one joint: they act at that joint.
///
/// A fixed tendon has the length L = sum c_i q_i of its joints. Where these are one, or all follow one joint q by linear couplings
/// (equality/joint), L = gear q, so that a force F along it is a torque gear F about that joint: its spring, damper, friction, rotor and
/// limit are gear^2 k, gear^2 d, |gear| f, gear^2 a and a range at the joint, its actuators such with the gear of the tendon. Exactly so,
/// since the coupling holds. Others, and spatial ones, do not act (mjcf_idle.h).
/// Source: MuJoCo documentation, "Tendon", and XML reference, "fixed".
#pragma once

#include <map>
#include <string>
#include <vector>

#include "murosimf/robot_formats/mjcf/mjcf_defaults.h"
#include "murosimf/robot_formats/mjcf/mjcf_frame.h"
#include "murosimf/robot_formats/mjcf/mjcf_names.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot_formats::mjcf {

struct MjcfTendon {
  files::XmlElement element;
  std::string joint;  ///< that all of its joints follow
  double gear = 0;    ///< [1 | m/rad] L over the position of that joint; not 0
};

/// Tendons that act at one joint, by name. Couplings with an offset, joints with `ref` or `springref` of their own, and dead bands of
/// springs (`springlength` of two numbers) are not supported.
[[nodiscard]] std::map<std::string, MjcfTendon> find_tendons(const files::XmlElement& root,
                                                             const MjcfDefaults& defaults, const MjcfCompiler& compiler,
                                                             const MjcfNames& names);

/// Adds the effects of tendons besides forces of actuators; to be called after reading the bodies. Throws SetupError for impossible numbers.
void apply_tendons(const std::map<std::string, MjcfTendon>& tendons, const MjcfDefaults& defaults,
                   const MjcfCompiler& compiler, robot_formats::RobotDescription& description);

}  // namespace murosimf::robot_formats::mjcf
