/// servo_bus.h - how targets get from the controller to the motors: held to their range, sent every so often, held, delayed,
/// filtered.
///
/// A servo with command_filter T comes to what arrives as the activation a of MuJoCo's `filterexact` does, a step behind:
///
///     a += (1 - exp(-h / T)) (target - a)
///
/// Servos of linkages whose commanded joints are others (loop_commanded) know where these joints' targets take them, on the branch where
/// they stand.
///
/// The servo of a joint that follows another one (mimic_joints.h) knows where the other one's target takes it; its own
/// target means nothing.
#pragma once

#include <algorithm>
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
  /// What control software wants of it, held to joint_target_range.
  [[nodiscard]] double wanted(int object) const noexcept {
    if (turning_.contains(object)) return turning_.target(object);
    const auto i = static_cast<std::size_t>(object);
    return std::clamp(target_[i], lowest_[i], highest_[i]);
  }
  /// [rad | m] where control software wants a joint to stand, also one that follows a rate; whatever its range of targets.
  [[nodiscard]] double position_target(int object) const noexcept { return target_[static_cast<std::size_t>(object)]; }
  [[nodiscard]] const VelocityJoints& turning() const { return turning_; }
  [[nodiscard]] const MimicJoints& coupled() const { return coupled_; }

 private:
  [[nodiscard]] double sent(int object) noexcept;
  [[nodiscard]] bool pass_on(double now, int object) noexcept;
  void filter(int object) noexcept;
  void couple() noexcept;

  VelocityJoints turning_;
  MimicJoints coupled_;
  multibody::LoopJoints linkages_;
  bool commands_linkages_;     // some joint is commanded
  std::span<const double> q_;  // [rad | m] where joints stand; empty if none is
  std::vector<double> rates_;  // [rad/s | m/s] not used; working memory
  std::span<const int> objects_;
  double step_;                           // [s] of the simulation
  bool plain_;                            // all are sent a position in every step, and take any
  std::vector<double> lowest_, highest_;  // [rad | m] of targets, by object
  std::vector<double> share_;       // [1] of the way to a target that a filter takes in a step, by object; 1: no filter
  std::vector<double> period_;      // [steps] by object; 0: every step
  std::vector<std::size_t> delay_;  // [steps] by object
  std::span<const double> target_;
  std::span<DelayLine> delayed_;
  std::span<double> sent_, age_;  // empty if no servo has a period
  std::span<double> filtered_;    // empty if no servo has a filter
  std::vector<double> present_;   // by object
};

}  // namespace murosimf::motion
