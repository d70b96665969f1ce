/// mjcf_actuator.h - actuators of an MJCF file as servos.
///
/// A position actuator with gains kp, kv and gear g at joint angle q pulls with g (kp (u - g q) - kv g q'), so its gains
/// about the joint are g^2 kp and g^2 kv and its limits are g times `forcerange`: servo law ideal_pd. A velocity
/// actuator is the damper that it is at target 0, a motor has no gains. MJCF knows neither speed limit nor supply.
/// Rotor inertia and friction are those of the joint (joint_armature, joint_damping, joint_friction), not repeated here.
/// Source: MuJoCo documentation, "Actuation model" and "Actuator shortcuts".
#pragma once

#include <map>
#include <string>
#include <vector>

#include "murosimf/formats/mjcf/mjcf_frame.h"
#include "murosimf/formats/mjcf/mjcf_names.h"
#include "murosimf/model/servo.h"

namespace murosimf::formats::mjcf {

struct MjcfActuator {
  Servo servo;
  double damping_ratio = 0;  ///< [1] instead of the servo's velocity_gain; 0: none (joint_inertia.h)
};

/// Servos by joint name. Several actuators at one joint add what the others lack. Throws SetupError for an unknown
/// joint; an actuator without a joint is refused unless `lenient`, then a line in `warnings`.
[[nodiscard]] std::map<std::string, MjcfActuator> read_actuators(const files::XmlElement& root,
                                                                 const MjcfDefaults& defaults,
                                                                 const MjcfCompiler& compiler, const MjcfNames& names,
                                                                 bool lenient, std::vector<std::string>& warnings);

}  // namespace murosimf::formats::mjcf
