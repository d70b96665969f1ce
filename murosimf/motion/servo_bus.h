/// servo_bus.h - how targets get from the controller to the motors: sent every so often, held, delayed.
///
/// The servo of a joint that follows another one (mimic_joints.h) knows where the other one's target takes it; its own
/// target means nothing.
#pragma once

#include <span>
#include <vector>

#include "murosimf/model/setup.h"
#include "murosimf/motion/delay_line.h"
#include "murosimf/motion/mimic_joints.h"
#include "murosimf/motion/velocity_joints.h"

namespace murosimf::motion {

class ServoBus {
 public:
  explicit ServoBus(Setup& setup);

  /// All motors know the present targets.
  void start() noexcept;
  /// To be called once per step of dt [s], a whole number of the simulation's steps: what is sent arrives as if it were called in each
  /// of them. False if a target is no sensible number.
  [[nodiscard]] bool step(double dt) noexcept;
  /// What the motor of a joint (an object of the model) knows: its position [rad | m], or the rate [rad/s | m/s] of one
  /// that follows a rate.
  [[nodiscard]] double target(int object) const noexcept { return present_[static_cast<std::size_t>(object)]; }
  /// The same of all, by object.
  [[nodiscard]] std::span<const double> targets() const noexcept { return present_; }
  /// What control software wants of it.
  [[nodiscard]] double wanted(int object) const noexcept {
    return turning_.contains(object) ? turning_.target(object) : target_[static_cast<std::size_t>(object)];
  }
  /// [rad | m] where a joint is to stand, also one that follows a rate.
  [[nodiscard]] double position_target(int object) const noexcept { return target_[static_cast<std::size_t>(object)]; }
  [[nodiscard]] const VelocityJoints& turning() const { return turning_; }
  [[nodiscard]] const MimicJoints& coupled() const { return coupled_; }

 private:
  [[nodiscard]] double sent(int object) noexcept;
  [[nodiscard]] bool pass_on(double now, int object) noexcept;
  void couple() noexcept;

  VelocityJoints turning_;
  MimicJoints coupled_;
  std::span<const int> objects_;
  double step_;                     // [s] of the simulation
  bool plain_;                      // all are sent a position in every step
  std::vector<double> period_;      // [steps] by object; 0: every step
  std::vector<std::size_t> delay_;  // [steps] by object
  std::span<const double> target_;
  std::span<DelayLine> delayed_;
  std::span<double> sent_, age_;  // empty if no servo has a period
  std::vector<double> present_;   // by object
};

}  // namespace murosimf::motion
