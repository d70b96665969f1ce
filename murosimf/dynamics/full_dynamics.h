/// full_dynamics.h - level `full_dynamics`: every link has its mass, joints move exactly along their reference.
///
/// With the joint accelerations qdd of the reference (joint_reference.h), a'_0 of the base follows from the first six
/// rows of the equations of motion; external damping (contacts) adds to the inertia:
///
///     (sum I_i + h D) a'_0 = F_ext - sum (I_i J_i qdd + p_i + h D J_i qdd)
///
/// The torques of this motion, tau_i = s_i . sum over the links behind joint i of (I a' + p - F_ext + h D a')
/// plus rotor inertia times qdd, minus the torques of the joint's damper and spring at the end of the step (passive_joint.h), are
/// the property `joint_torque` (of a coupled joint without servo, its leader's); excess over the servo is counted (torque_watch.h).
/// Source: paper 4.3, eq. (3); joint torques by the recursive Newton-Euler algorithm (multibody/inverse_dynamics.h).
/// Differs: joint motion is smoothed by the filter unless the paper's `linear` is selected.
#pragma once

#include "murosimf/dynamics/joint_reference.h"
#include "murosimf/dynamics/moving_tree.h"
#include "murosimf/dynamics/passive_joint.h"
#include "murosimf/dynamics/servo/torque_watch.h"
#include "murosimf/world/motion_level.h"

namespace murosimf::dynamics {

struct FullDynamicsOptions {
  JointReferenceOptions reference;
  MovingTreeOptions tree;
};

class FullDynamics final : public MotionLevel, private collision::ImpulseResponse {
 public:
  static constexpr LevelTraits has{.dynamic = true, .joint_torque = true};

  /// Throws SetupError if the model has no mass.
  explicit FullDynamics(Setup& setup, const FullDynamicsOptions& options = {});

  [[nodiscard]] LevelTraits traits() const override { return has; }
  void state(StateArchive& archive) override { archive(tree_); }
  void initialize() override;
  void step(const Instant& instant) noexcept override;
  [[nodiscard]] Momentum hand_over() noexcept override { return tree_.hand_over(); }
  void take_over(const Momentum& momentum) override;
  [[nodiscard]] bool goes_with(const Algorithm& other) const override;
  [[nodiscard]] std::unique_ptr<LaneGroup> join(std::span<Algorithm* const> members) const override;

 private:
  friend class FullLanes;

  void start_observing() noexcept;
  [[nodiscard]] bool free_pass(double dt) noexcept override;
  [[nodiscard]] std::size_t coordinates() const noexcept override { return 6; }
  [[nodiscard]] Vec3d free_velocity(int object, const Vec3d& point, const Vec3d& velocity) const noexcept override;
  void respond(int object, const Vec3d& point, const Mat3d& directions,
               collision::ResponseRows& y) const noexcept override;
  void apply(std::span<const double> z) noexcept override;

  void step_rk4(const Instant& instant) noexcept;
  void end_step(const Instant& instant) noexcept;
  void predict_contacts(double dt) noexcept;
  void begin_step(double dt) noexcept;
  [[nodiscard]] bool advance_joints(double dt) noexcept;
  void prepare_base() noexcept;
  void solve_base(double dt) noexcept;
  void find_torques(const Instant& instant) noexcept;
  void load_leaders() noexcept;
  void watch_torques(const Instant& instant) noexcept;

  MovingTree tree_;
  JointReference reference_;
  TorqueWatch watch_;
  std::span<double> joint_torque_;
  std::vector<double> rotor_;               // [kg m^2 | kg] by link
  std::vector<PassiveJoint> passive_;       // by link
  std::vector<double> old_rate_;            // [rad/s | m/s] by object
  std::vector<double> joint_acceleration_;  // [rad/s^2 | m/s^2] by link
  std::vector<Twistd> joint_motion_;        // J_i qdd by link: the part of a' due to the joints alone
  std::vector<Wrenchd> link_force_;         // [N m, N] about O, by link
  std::vector<bool> has_servo_;             // by object
  Wrenchd bias_;                            // [N m, N] force that the joints' motion requires of the base
  double dt_ = 0;                           // [s] of the present step
  bool joints_sane_ = true;                 // in the present step
  Twistd base_;                             // a'_0
};

}  // namespace murosimf::dynamics
