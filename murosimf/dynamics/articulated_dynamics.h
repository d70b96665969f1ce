/// articulated_dynamics.h - level `articulated_dynamics`: servos produce torques, the motion of the whole tree results from forces.
///
/// Forward dynamics by the articulated-body algorithm (multibody/articulated_body.h); servos, stops and contacts
/// enter linearly implicit, as inertia of the joint or of the body. Joints: qd += h qdd, q += h qd.
/// Friction of joints sticks (multibody/friction_solver.h): which joint sticks and which slides is settled together with the contacts of the
/// step. In an island of touching robots the decision of the preceding step holds. rk4 has friction as a damper, with which loaded
/// joints creep (dynamics/passive_joint.h). Coupled joints are held together, and loops closed, after every pass
/// (coupling_forces.h).
/// Source: paper, outlook (7); Featherstone 2008, ch. 7.
#pragma once

#include "murosimf/dynamics/coupling_forces.h"
#include "murosimf/dynamics/moving_tree.h"
#include "murosimf/dynamics/servo/joint_drives.h"
#include "murosimf/dynamics/servo/saturation_watch.h"
#include "murosimf/multibody/articulated_body.h"
#include "murosimf/multibody/friction_solver.h"
#include "murosimf/world/motion_level.h"

namespace murosimf::dynamics {

class ArticulatedDynamics final : public MotionLevel, private collision::ImpulseResponse {
 public:
  static constexpr LevelTraits has{.dynamic = true, .joint_torque = true, .servos = true};

  /// Throws SetupError if the model has no mass, a servo is impossible, or a joint moves no inertia at all.
  /// `servo_law`: of all servos, instead of their own (empty: their own).
  explicit ArticulatedDynamics(Setup& setup, const MovingTreeOptions& options = {}, const std::string& servo_law = {});

  [[nodiscard]] LevelTraits traits() const override { return has; }
  void state(StateArchive& archive) override { archive(tree_); }
  void initialize() override;
  void step(const Instant& instant) noexcept override;
  [[nodiscard]] Momentum hand_over() noexcept override { return tree_.hand_over(); }
  void take_over(const Momentum& momentum) override;
  [[nodiscard]] bool goes_with(const Algorithm& other) const override;
  [[nodiscard]] std::unique_ptr<LaneGroup> join(std::span<Algorithm* const> members) const override;

 private:
  friend class ArticulatedLanes;

  [[nodiscard]] bool free_pass(double dt) noexcept override;
  [[nodiscard]] std::size_t coordinates() const noexcept override { return 5 + bodies_.size() + couplings_.size(); }
  [[nodiscard]] Vec3d free_velocity(int object, const Vec3d& point, const Vec3d& velocity) const noexcept override;
  void respond(int object, const Vec3d& point, const Mat3d& directions,
               collision::ResponseRows& y) const noexcept override;
  void apply(std::span<const double> z) noexcept override;
  void add_impulses(std::span<const double> z) noexcept;

  void step_rk4(double dt) noexcept;
  [[nodiscard]] bool advance(double dt) noexcept;
  [[nodiscard]] bool end_step() noexcept;
  void begin_step(double dt) noexcept;
  void drive_joints(double dt) noexcept;
  void recall_loads() noexcept;
  void keep_loads() noexcept;
  void gather_loads(double dt) noexcept;
  [[nodiscard]] bool solve(multibody::Loads loads) noexcept;
  void factor() noexcept;
  void couple() noexcept;
  void drive_joints_explicitly() noexcept;
  void solve_explicitly() noexcept;
  /// a'_0 for the loads of the sweep; pA_0 is the force that the base lacks, hence the sign.
  [[nodiscard]] Twistd base_acceleration() noexcept {
    return tree_.base_acceleration(bodies_[0].inertia, -1.0 * bodies_[0].force);
  }
  void predict_contacts(double dt) noexcept {
    tree_.predict_contacts(dt, [&](int link) -> const Twistd& { return bodies_[link].acceleration; });
  }
  void start_loads();
  void report_torques() noexcept;
  /// Motor torque [N m | N], averaged over the step.
  [[nodiscard]] double motor_torque(std::size_t link) const noexcept {
    return friction_[link].line.torque - friction_[link].line.inertia * bodies_[link].joint_acceleration;
  }
  void finish_drives() noexcept;
  void advance_joints(double dt) noexcept;
  [[nodiscard]] bool accelerations_are_sane() const noexcept;
  void check_inertias();

  MovingTree tree_;
  std::string servo_law_;
  JointDrives drives_;
  CouplingForces couplings_;
  std::span<double> joint_torque_;
  std::span<double> motor_torque_;  // empty if no algorithm reads it
  std::span<double> joint_load_;
  std::span<Twistd> felt_acceleration_;
  SaturationWatch saturation_;
  std::vector<JointDrive> viscous_;                           // by link: friction of the servo's gear
  std::vector<multibody::FrictionalJoint<double>> friction_;  // by link
  std::vector<multibody::ArticulatedLink<double>> bodies_;
  std::vector<Twistd> change_;  // by link: change of a' due to impulses; working memory
  std::vector<double> root_;    // by link: square root of inverse_D, for responses
  double dt_ = 0;               // [s] of the present step
  bool targets_sane_ = true;    // in the present step
};

}  // namespace murosimf::dynamics
