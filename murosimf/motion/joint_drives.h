/// joint_drives.h - everything that acts on the joints of a robot from inside: servos, dampers and dry friction, the
/// ends of their range.
///
/// A joint without servo is free. At an end of its range a joint meets a spring and a damper, implicit as the servo is,
///
///     torque = k (end - q - h qd) - d qd,   k = T / 0.25 degree (T / 0.5 mm),  d = k * 5 ms
///
/// with T the larger of the servo's stall torque and the robot's weight times 0.1 m (its weight, for a slider): a fallen
/// robot bends its stops by less than a degree.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "murosimf/model/properties.h"
#include "murosimf/model/setup.h"
#include "murosimf/motion/delay_line.h"
#include "murosimf/motion/servo_law.h"
#include "murosimf/motion/turning_joints.h"

namespace murosimf::motion {

class JointDrives {
 public:
  /// Throws SetupError if a servo is impossible.
  explicit JointDrives(Setup& setup);

  /// Joints stand where their targets are, at rest.
  void initialize(std::span<double> q, std::span<double> qd) noexcept;
  /// Joints stay as they are; all motors know the present targets.
  void take_over() noexcept;
  /// To be called once per step: takes the targets on their way to the motors. False if one is no sensible number.
  [[nodiscard]] bool take_targets() noexcept;
  /// Takes whole turns out of the positions [rad] of wheels (turning_joints.h).
  void wrap(std::span<double> q) const noexcept { turning_.wrap(q); }
  /// What acts in a joint.
  struct Answer {
    double motor_torque = 0;             ///< [N m] of the motor, now
    JointDrive servo;                    ///< motor and viscous friction of the gear, without rotor
    JointDrive all;                      ///< with rotor, dampers, and the end of the range
    const GearFriction* gear = nullptr;  ///< dry friction of the servo; null: none
    double coulomb = 0;                  ///< [N m | N] dry friction of the joint itself
  };
  /// Joint `i` (an object of the model), for a step of `dt` [s].
  [[nodiscard]] Answer drive(int i, double q, double qd, double dt) const noexcept;

 private:
  struct Joint {
    std::unique_ptr<ServoLaw> law;
    double rotor = 0;                    // [kg m^2 | kg]
    double damping = 0;                  // [N m s/rad | N s/m] of the joint itself
    double viscous = 0;                  // [N m s/rad] of the servo
    double coulomb = 0;                  // [N m | N] dry friction of the joint itself
    const GearFriction* gear = nullptr;  // dry friction of the servo; null: none
    double lowest = 0, highest = 0;      // [rad | m]
    double stop_stiffness = 0;           // [N m/rad | N/m]; 0: no ends
    double command_delay = 0;            // [s]
  };
  [[nodiscard]] static Joint make_joint(const Model& model, int i, double weight);

  /// What control software wants of a joint: its position, or the rate of one that follows a rate.
  [[nodiscard]] double target(int i) const noexcept { return turning_.contains(i) ? turning_.target(i) : target_[i]; }

  std::vector<Joint> joints_;  // by object
  TurningJoints turning_;
  std::span<const int> objects_;
  std::span<const double> target_;
  std::span<DelayLine> delayed_;
  std::vector<double> present_;  // [rad | m | rad/s | m/s] by object: the target that the motor knows
};

}  // namespace murosimf::motion
