/// joint_reference.h - joint motion of the levels that do not simulate servos: conversion of desired positions to
/// positions and rates.
///
///     filter:  qdd = (wf^2 (target - q - dt qd) - 2 wf qd) / (1 + 2 wf dt + wf^2 dt^2)
///     linear:  q reaches the target at constant rate within one control cycle
///     exact:   q = target at the end of the step, qd = (target - q) / dt
///
/// The filter is implicit Euler of the critically damped q'' = wf^2 (target - q) - 2 wf q'; wf = 120 rad/s lags 17 ms
/// behind. `linear` is the paper's assumption for dynamics (4.3): the target is reached within one control cycle; `exact` the one
/// for kinematic walking and the rigid body (4.1, 4.2): the desired position is the present one. A target that jumps is then a
/// rate of one step; a controller at a lower rate than the steps makes such jumps in every cycle.
/// A joint whose servo follows a rate (velocity_joints.h) comes to its rate target within 1 / wf, also with `linear`:
///
///     qdd = wf (rate target - qd) / (1 + wf dt)
///
/// A level that takes over finds joints beside their reference: servos have let them sag, or the preceding reference was of another
/// kind. The initial offset o = q - reference,
///
///     o = q + lag - target        lag = 2 qd / wf (filter: its acceleration begins at 0), 0 (linear, exact)      o' = -o / 0.1 s
///
/// is added to the target (filter, exact) or to the line (linear), and decays, so that the base does not jerk. Implicit Euler. For a
/// second after servos no joint gets faster than its servo allows, unless it already is:
///
///     |qd| <= w_0 max(0.1, 1 - tau / T)     w_0, T: no-load rate and stall torque of its servo at its duty limit;
///                                           tau: torque of its motion
///
/// (tau: torque_need in the direction of the motion, known at full_dynamics, else 0). The distance that a joint falls behind is then
/// added to o. Otherwise limbs that carry the robot throw it up when they catch up (docs/levels.md has the measure).
/// The position of a joint that follows another one (mimic_joints.h) is that of the coupling; its own target is ignored.
/// The positions of passive joints in loops are those that close the loops (multibody/loop_joints.h), whatever their targets and ranges.
/// Targets are held to the joint's range and its joint_target_range.
/// No joint is faster than its largest rate (joint_rate_limit): the filter's rate is limited, the slope of a line is limited, and
/// an exact reference is reached later.
/// Joints stop at the ends of their range (joint_range), at rest. Same state (q, qd) as a simulated servo, so levels can be
/// exchanged.
#pragma once

#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include "murosimf/dynamics/integrator.h"
#include "murosimf/dynamics/mimic_joints.h"
#include "murosimf/dynamics/pose_columns.h"
#include "murosimf/dynamics/velocity_joints.h"
#include "murosimf/multibody/loop_joints.h"

namespace murosimf::dynamics {

enum class ReferenceKind { filter, linear, exact };

struct ReferenceEntry {
  std::string_view name, meaning;
  ReferenceKind kind;
};

[[nodiscard]] std::span<const ReferenceEntry> joint_references();

struct JointReferenceOptions {
  ReferenceKind kind = ReferenceKind::filter;
  double filter_frequency = 120.0;  ///< [rad/s] wf
  double control_period = 0.01;     ///< [s] one control cycle, for `linear`
  bool carries = true;              ///< limbs carry the robot: servos limit them after a takeover
};

class JointReference {
 public:
  JointReference(Setup& setup, const JointReferenceOptions& options);

  /// Joints start at their targets, at rest.
  void initialize(PoseColumns& columns) noexcept;
  /// Continues from the present joint positions; the offsets from the reference decay. After a level with a reference of the same
  /// kind nothing changes.
  void take_over(const PoseColumns& columns) noexcept;
  /// Whether positions and targets are sane numbers.
  [[nodiscard]] bool is_sane(const PoseColumns& columns) const noexcept;
  /// Advances q and qd by dt [s] > 0. False, and nothing changed, if a position or target is not sane.
  [[nodiscard]] bool advance(PoseColumns& columns, double dt) noexcept;
  /// Acceleration [rad/s^2 | m/s^2] of the filter's differential equation, q'' = wf^2 (target - q) - 2 wf q'; of a joint
  /// that follows a rate, q'' = wf (rate target - q').
  [[nodiscard]] double acceleration(const PoseColumns& columns, int joint) const noexcept;
  /// Reduces the offsets by their decay in dt [s]; advance() includes it.
  void fade_offsets(double dt) noexcept;
  /// Stops joints beyond the ends of their range at the end; coupled joints follow their leaders.
  void stop_at_limits(PoseColumns& columns) const noexcept;
  /// Sets the torques by object [N m | N], of a level that computes those of its motion (torque_watch.h).
  void know_torques(std::span<const double> needed) noexcept { torque_need_ = needed; }
  [[nodiscard]] const MimicJoints& coupled() const { return coupled_; }
  /// Throws SetupError if the reference has no differential equation for `integrator`.
  void check(Integrator integrator) const;

 private:
  /// The speed-torque line of a joint's servo, at the largest duty cycle that its firmware gives.
  struct Motor {
    double no_load_rate = std::numeric_limits<double>::infinity();  // [rad/s | m/s]
    double stall_torque = std::numeric_limits<double>::infinity();  // [N m | N]
  };
  [[nodiscard]] static Motor motor_of(const Model& model, int joint);
  [[nodiscard]] double limited_target(int joint) const noexcept;
  [[nodiscard]] double limited_rate(int joint, double rate) const noexcept;
  [[nodiscard]] double limited_rate(int joint, double rate, double now) const noexcept;
  [[nodiscard]] double target(int joint) const noexcept;
  [[nodiscard]] double offset_of(const PoseColumns& columns, int joint) const noexcept;
  [[nodiscard]] bool catches_up() const noexcept { return catch_up_time_ > 0; }
  [[nodiscard]] double largest_rate(int joint, double now) const noexcept;
  void count_down(double dt) noexcept;
  void filter(PoseColumns& columns, double dt) noexcept;
  void linear(PoseColumns& columns, double dt) noexcept;
  void follow_exactly(PoseColumns& columns, double dt) noexcept;
  void fall_behind(const PoseColumns& columns, int joint) noexcept;
  void turn(PoseColumns& columns, double dt) const noexcept;

  JointReferenceOptions options_;
  VelocityJoints turning_;
  MimicJoints coupled_;
  multibody::LoopJoints of_loops_;
  std::span<const double> target_;  // [rad | m] desired positions
  std::span<double> offset_;        // [rad | m] o, by object
  double& kind_;                    // properties::joint_reference_kind
  double& catch_up_time_;           // [s] remaining, during which joints with an offset are limited by their servos
  std::span<const double> torque_need_;           // [N m | N] by object; empty where the level does not compute it
  std::vector<Motor> motors_;                     // by object
  std::vector<MimicJoints::Range> target_range_;  // by object
  std::vector<int> leader_;                       // [objects] the joint that a joint follows; itself if none
  std::vector<double> ratio_;                     // [objects] to the leader
  bool limited_ = false;                          // some joint has a largest rate
  std::span<double> cycle_target_;                // [rad | m] the target that the present cycle runs to (linear only)
};

}  // namespace murosimf::dynamics
