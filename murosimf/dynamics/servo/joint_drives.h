/// joint_drives.h - internal torques of a robot's joints: servos, dampers, springs and dry friction,
/// and the ends of their range (joint_stop.h).
///
/// A joint without servo is free. No servo drives its joint faster than the joint's limit (rate_limit.h). Torques are linearly implicit
/// in the joint's acceleration of this step, tau = torque - inertia qdd: implicit Euler of the linearized drive. With h = 0 the result
/// is the torque of this instant. Dry
/// friction is a budget that the level spends (multibody/friction_solver.h).
/// Springs are the exception: implicit Euler would damp oscillations like a damper of h k. Springs use average
/// acceleration,
///
///     torque = k (rest - q),   inertia = h^2 k / 4
///
/// which with the semi-implicit step of the joint conserves energy at any h, and oscillates slower by the share (h w)^2 / 12.
/// Source: Newmark's method with beta = 1/4, gamma = 1/2 (Hughes, The Finite Element Method, sec. 9.1).
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "murosimf/dynamics/joint_stop.h"
#include "murosimf/dynamics/passive_joint.h"
#include "murosimf/dynamics/rate_limit.h"
#include "murosimf/dynamics/servo/backlash.h"
#include "murosimf/dynamics/servo/joint_drive.h"
#include "murosimf/dynamics/servo/servo_bus.h"
#include "murosimf/dynamics/servo/servo_condition.h"
#include "murosimf/dynamics/servo/servo_law.h"
#include "murosimf/multibody/friction_solver.h"

namespace murosimf::dynamics {

class JointDrives {
 public:
  /// `law`: of all servos, instead of their own (empty: their own). Throws SetupError if a servo is impossible.
  explicit JointDrives(Setup& setup, const std::string& law = {});

  /// Places the joints at their targets, at rest.
  void initialize(std::span<double> q, std::span<double> qd) noexcept;
  /// Keeps the joints; all motors receive the present targets. qd [rad/s | m/s] by object.
  void take_over(std::span<const double> qd) noexcept;
  /// To be called once per step of dt [s]: moves targets on towards the motors. False if a target is not sane.
  [[nodiscard]] bool take_targets(double dt) noexcept { return bus_.step(dt); }
  /// Removes whole turns from the positions [rad] of wheels (velocity_joints.h).
  void wrap(std::span<double> q) const noexcept { bus_.turning().wrap(q); }

  /// Whether copies of the robot differ in numbers only: no wheels, and no servos with backlash or temperature.
  [[nodiscard]] bool are_alike() const noexcept { return remembering_.empty() && bus_.turning().joints().empty(); }

  /// Fills the internal torques of joint `i` (an object of the model), for a step of `dt` [s]; returns the viscous friction of the
  /// servo's gear, which is a part of them.
  JointDrive drive(int i, double q, double qd, double dt, multibody::FrictionalJoint<double>& joint) const noexcept;
  /// Converts the result of drive() with a step of 0: the motor's torque of this instant, and friction as a damper.
  static void brake_explicitly(multibody::FrictionalJoint<double>& joint) noexcept;
  /// Inertia [kg m^2 | kg] that always moves with the joint, besides links.
  [[nodiscard]] double firm_inertia(int i) const noexcept { return backlash_.at(i) ? 0 : joints_[i].rotor; }

  /// Result of a step for a joint.
  struct Outcome {
    double motor_torque = 0;  ///< [N m] on average
    double torque = 0;        ///< [N m] of motor and gear
    double position = 0;      ///< [rad] after the step
    double rate = 0;          ///< [rad/s] after the step
  };
  /// Joints whose servo has memory; only these need `finish`.
  [[nodiscard]] std::span<const int> remembering() const { return remembering_; }
  void finish(int i, const Outcome& outcome, double dt) noexcept;

 private:
  friend class JointDriveLanes;

  struct Joint {
    std::unique_ptr<ServoLaw> law;
    double rotor = 0;                    // [kg m^2 | kg]
    RateLimit rate_limit;                // of its servo
    PassiveJoint passive;                // damper and spring of the joint itself
    double viscous = 0;                  // [N m s/rad] of the servo
    double coulomb = 0;                  // [N m | N] dry friction of the joint itself
    const GearFriction* gear = nullptr;  // dry friction of the servo; null: none
    JointStop stop;
  };
  /// Adds damper and spring of the joint itself, and the ends of its range.
  template <class S>
  static void add_passive(const Joint& joint, const S& q, const S& qd, double dt, DriveOf<S>& rest,
                          multibody::RangeEnd<S>& end) {
    damp(rest, joint.passive.damping, qd, dt);
    if (joint.passive.stiffness > 0) pull(rest, joint.passive, q, dt);
    if (!joint.stop.stops()) {
      end = {};
    } else if (dt > 0) {
      end = end_ahead(joint.stop, q, qd, dt);
    } else {
      stop(rest, joint.stop, q, qd);
    }
  }
  [[nodiscard]] static Joint make_joint(const Model& model, int i, const std::string& law);
  [[nodiscard]] MotorTorque motor(int i, double q, double rate, double dt) const noexcept;

  std::vector<Joint> joints_;  // by object
  std::span<const int> objects_;
  ServoBus bus_;
  ServoCondition condition_;
  Backlash backlash_;
  std::vector<int> remembering_;
};

}  // namespace murosimf::dynamics
