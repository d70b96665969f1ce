/// mjcf_actuator.h - actuators of an MJCF file as servos.
///
/// An actuator with gear g at joint angle q has the force g (gain u + b0 + b1 g q + b2 g q'), u its control (mjcf_gains.h). With b1 < 0 that
/// is a servo of law ideal_pd with the gains -g^2 b1 and -g^2 b2 about the joint; its target is the position without force,
///
///     target = (b0 + gain u) / (-b1 g)
///
/// or, without b1, a rate: (b0 + gain u) / (-b2 g). Without both it is a motor, its control a torque. `ctrlrange` bounds the
/// target, or the torque of a motor; `forcerange`, g times, bounds the torque. MJCF has neither speed limit nor supply.
/// An actuator with integrated control (`intvelocity`, `dyntype` integrator) moves that target at a rate; here software gives the
/// target itself, bounded by `actrange`.
/// Rotor inertia and friction are those of the joint (joint_armature, joint_damping, joint_friction), not repeated here.
/// Source: MuJoCo documentation, "Actuation model" and "Actuator shortcuts".
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/model/servo.h"
#include "murosimf/robot_formats/mjcf/mjcf_frame.h"
#include "murosimf/robot_formats/mjcf/mjcf_names.h"
#include "murosimf/robot_formats/mjcf/mjcf_tendons.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot_formats::mjcf {

/// The drive of one joint.
struct MjcfActuator {
  Servo servo;
  double damping_ratio = 0;           ///< [1] instead of the servo's velocity_gain; 0: none (joint_inertia.h)
  std::optional<Vec3d> target_range;  ///< lowest, highest, 0: of the target, as JointDescription has it
  double inherited_range = 0;         ///< [1] share of the joint's range that is the target's; 0: target_range holds
  double per_range = 1;               ///< [rad per unit of the control] for inherited_range
};

/// The meaning of one actuator's control for its joint.
struct MjcfControl {
  std::string joint;         ///< empty: none that is simulated
  bool is_position = false;  ///< the control is a position, target = offset + scale u; else a rate or a torque
  double scale = 1, offset = 0;
};

struct MjcfActuators {
  std::map<std::string, MjcfActuator> by_joint;
  std::vector<MjcfControl> controls;  ///< in the order of the file
};

/// Sets the torques [N m] that a servo can give, in any order.
void set_torque_range(Servo& servo, double one, double other);

/// Several actuators at one joint: the largest of each number counts, with a line in the notes of `description`. One at a tendon that acts
/// at a joint (mjcf_tendons.h) counts as one at that joint. An actuator without a joint, or of a kind that is not simulated, moves nothing,
/// with a warning. Throws SetupError for an unknown joint.
[[nodiscard]] MjcfActuators read_actuators(const files::XmlElement& root, const MjcfDefaults& defaults,
                                           const MjcfCompiler& compiler, const MjcfNames& names,
                                           const std::map<std::string, MjcfTendon>& tendons,
                                           robot_formats::RobotDescription& description);

/// To be called after reading the bodies: actuators of joints that are not in `description` (a ball, the base) move nothing, with a warning.
void drop_idle_controls(MjcfActuators& actuators, robot_formats::RobotDescription& description);

}  // namespace murosimf::robot_formats::mjcf
