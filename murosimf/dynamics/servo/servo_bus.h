/// servo_bus.h - transfer of targets from the controller to the motors: limited to their range, sent periodically, held, delayed,
/// filtered.
///
/// A servo with command_filter T approaches arriving targets as the activation a of MuJoCo's `filterexact` does, a step behind:
///
///     a += (1 - exp(-h / T)) (target - a)
///
/// Servos of linkages whose commanded joints are others (loop_commanded) receive the positions that result from these joints' targets, on
/// the present branch of the linkage.
///
/// The servo of a joint that follows another one (mimic_joints.h) receives the position that results from the other one's target; its own
/// target is ignored.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "murosimf/dynamics/mimic_joints.h"
#include "murosimf/dynamics/servo/delay_line.h"
#include "murosimf/dynamics/velocity_joints.h"
#include "murosimf/world/setup.h"

namespace murosimf::dynamics {

class ServoBus {
 public:
  explicit ServoBus(Setup& setup);

  /// Gives all motors the present targets.
  void start() noexcept;
  /// To be called once per step of dt [s], a whole number of the simulation's steps: targets arrive as if it were called in each
  /// of them. False if a target is not sane.
  [[nodiscard]] bool step(double dt) noexcept;
  /// Target that has arrived at the motor of a joint (an object of the model): its position [rad | m], or the rate [rad/s | m/s] of one
  /// that follows a rate.
  [[nodiscard]] double target(int object) const noexcept { return present_[static_cast<std::size_t>(object)]; }
  /// The same of all, by object.
  [[nodiscard]] std::span<const double> targets() const noexcept { return present_; }
  /// Target of the control software, limited to joint_target_range.
  [[nodiscard]] double wanted(int object) const noexcept {
    if (turning_.contains(object)) return turning_.target(object);
    const auto i = static_cast<std::size_t>(object);
    return std::clamp(target_[i], lowest_[i], highest_[i]);
  }
  /// Desired position [rad | m] of a joint by the control software, also of one that follows a rate; without limits.
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
  bool commands_linkages_;     // some joint is commanded (loop_commanded)
  std::span<const double> q_;  // [rad | m] joint positions; empty if no joint is commanded
  std::vector<double> rates_;  // [rad/s | m/s] ignored; working memory
  std::span<const int> objects_;
  double step_;                           // [s] of the simulation
  bool plain_;                            // all joints receive a position in every step, without limits
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

}  // namespace murosimf::dynamics
