/// mjcf_tendons.h - which tendons act, and those whose length hangs on one joint: what they do is done at that joint.
///
/// A fixed tendon has the length L = sum c_i q_i of its joints. Where these are one, or all follow one joint q by linear couplings
/// (equality/joint), L = gear q, so that a force F along it is a torque gear F about that joint: its spring, damper, friction, rotor and
/// limit are gear^2 k, gear^2 d, |gear| f, gear^2 a and a range at the joint, its actuators such with the gear of the tendon. Exactly so,
/// since the coupling holds. Those over several joints, those that an equality holds, and spatial ones are joints of their own
/// (mjcf_joint_tendons.h). One with a part outside of the robot does not act (mjcf_idle.h).
/// Source: MuJoCo documentation, "Tendon", and XML reference, "fixed".
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "murosimf/robot_formats/mjcf/mjcf_defaults.h"
#include "murosimf/robot_formats/mjcf/mjcf_frame.h"
#include "murosimf/robot_formats/mjcf/mjcf_names.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot_formats::mjcf {

struct MjcfTendon {
  files::XmlElement element;
  std::string joint;  ///< that all of its joints follow; of one over several joints its slider
  double gear = 0;    ///< [1 | m/rad] L over the position of that joint; not 0
  std::vector<std::pair<std::string, double>>
      parts;  ///< of one over several joints: these, with coefficients [1 | m/rad]
  std::vector<robot_formats::TendonBranchDescription> path{};  ///< of a spatial one
  bool tied = false;                                           ///< an equality holds it

  [[nodiscard]] bool has_slider() const { return !parts.empty() || !path.empty(); }
};

/// By name, all whose joints are the robot's. Couplings with an offset, joints with `ref` or `springref` of their own, dead bands of
/// springs (`springlength` of two numbers) and limits of actuators together (`actuatorfrcrange`) are beyond what acts at one joint.
[[nodiscard]] std::map<std::string, MjcfTendon> find_tendons(const files::XmlElement& root,
                                                             const MjcfDefaults& defaults, const MjcfCompiler& compiler,
                                                             const MjcfNames& names);

/// [N s/m ...] A number of a tendon, 0 if the file does not say. Throws SetupError if it is negative.
[[nodiscard]] double tendon_number(const MjcfAttributes& attributes, const char* name);

/// Once the bodies are read: what tendons do at one joint besides passing on forces of actuators. Throws SetupError for impossible numbers.
void apply_tendons(const std::map<std::string, MjcfTendon>& tendons, const MjcfDefaults& defaults,
                   const MjcfCompiler& compiler, robot_formats::RobotDescription& description);

}  // namespace murosimf::robot_formats::mjcf
