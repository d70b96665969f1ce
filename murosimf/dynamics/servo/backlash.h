/// backlash.h - play between the motor side of a gear and its output, without an additional joint.
///
/// The motor side (rotor, motor, friction of the gear) is at the angle q + x, |x| <= b/2, and turns with the rate w_m.
///
///   * x = +b/2 or -b/2: it touches the output on that side, and both move as one: the rotor's inertia J_a, the motor and the
///     gear's friction act on the joint. On arrival the joint receives the difference of the two rates within the step,
///     by the torque J_a (w_m - qd)/h: inelastic. A side can only push: where it would have to pull it separates.
///   * between: the servo has no effect on the joint, and the motor side turns freely,
///         D = J_a + A,   p = D w_m + h tau,   w_m+ = sign(p) max(0, |p| - h F)/D,   x += h (w_m+ - qd+)
///     with the motor's torque tau - A w_m' and the budget F without load (gear_friction.h). The encoder sits at the output.
///
/// Source: the project's own; rigid contact with one side at a time, as a two-mass system with an infinitely stiff gear.
#pragma once

#include <span>
#include <vector>

#include "murosimf/dynamics/servo/servo_law.h"
#include "murosimf/math/assert.h"
#include "murosimf/world/setup.h"

namespace murosimf::dynamics {

class Backlash {
 public:
  explicit Backlash(Setup& setup);

  /// Starts in the middle of the play, with the rates of the joints.
  void start(std::span<const double> qd) noexcept;

  [[nodiscard]] bool at(int joint) const noexcept { return gears_[static_cast<std::size_t>(joint)].half_play > 0; }
  /// Whether the motor side touches the output (joints without backlash always do).
  [[nodiscard]] bool touches(int joint) const noexcept { return !at(joint) || side_[joint] != 0; }
  /// [rad/s] of the motor side.
  [[nodiscard]] double rate(int joint) const noexcept { return rate_[joint]; }
  /// J_a (w_m - qd)/h [N m] of a joint whose sides touch, at the beginning of a step of `dt` [s] > 0.
  [[nodiscard]] double arrival(int joint, double qd, double dt) const noexcept {
    MUROSIMF_ASSERT(dt > 0);
    return gears_[joint].inertia * (rate_[joint] - qd) / dt;
  }
  /// Updates after a step in which the sides touched: `torque` [N m] of motor and gear, `qd` [rad/s] of the joint after it.
  void follow(int joint, double torque, double qd, double dt) noexcept;
  /// Updates after a step in which they did not touch: `motor` is the motor's torque at its own rate.
  void turn(int joint, const MotorTorque& motor, double qd, double dt) noexcept;

 private:
  struct Gear {
    double half_play = 0;  // [rad] 0: none
    double inertia = 0;    // [kg m^2] J_a
    const GearFriction* friction = nullptr;
  };
  std::vector<Gear> gears_;               // by object
  std::span<double> play_, rate_, side_;  // empty if no servo has backlash
};

}  // namespace murosimf::dynamics
