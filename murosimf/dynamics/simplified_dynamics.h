/// simplified_dynamics.h - level `simplified_dynamics`: the robot moves as one rigid body with its common mass,
/// center of mass and inertia; joints follow their targets.
///
///     m vc' = m g + sum f            L' = sum ((r - c) x f + n)            w = I^-1 L
/// L is the angular momentum of the composite body about its center of mass. Only external forces change it, also
/// L is the angular momentum of the composite body about its center of mass. It changes by forces from outside only, also
/// while limbs change the inertia I(q): a robot that draws its limbs in turns faster. With joints at rest these are Euler's
/// equations, I w' + w x I w = sum ((r - c) x f + n); a step solves these for w' and takes the moment from them,
///
///     L_k+1 = I_k w_k + dt (I_k w' + w_k x I_k w_k)      Q_k+1 = exp(dt (w_k + dt w')) Q_k      w_k+1 = I_k+1^-1 L_k+1
///
/// so that L is conserved up to rounding. While anything touches the robot, L_k+1 = I(Q_k+1, q_k) (w_k + dt w') instead: contacts
/// have been solved for that rate, and a stack of boxes comes to rest; the difference is one of dt^2. In flight the base turns with
/// the rate in the middle of the step, w_k + dt w'/2, as in moving_tree.h: otherwise a tumbling body would gain energy. With
/// Runge-Kutta L is a part of its state, in the place of w.
/// L is not the sum over the links: motions of limbs relative to the base do not contribute, and never turn it.
///
/// External forces enter implicitly through their damping D (contact.h): (diag(I, m) + dt D_c) a = forces at the
/// beginning of the step, with D_c the damping of all bodies moved to the center of mass. A ball is the same thing
/// with a single object.
///
/// Effect of joint motion on the base:
///  * center-continuous (default): c and vc are integrated, the base follows from them: r_0 = c - R c_B(q),
///    v_0 = vc - w x R c_B - R c_B'. Limbs moving in free flight do not move the center of mass.
///  * base-rigid (the paper's literal reading): the base is integrated as part of the rigid body, limbs then move the
///    center of mass (55 mm in the project's flight test), and w by Euler's equations, whatever the change of I.
/// Joint motion never turns the base: that is the simplification; `full_dynamics` has it.
/// A base that is bolted to the world (model/fixed_base.h) keeps its place, whatever pushes the robot: joints follow their targets.
/// Source: paper 4.2.
#pragma once

#include <optional>
#include <vector>

#include "murosimf/collision/contact_laws/impulse_response.h"
#include "murosimf/dynamics/contact_trials.h"
#include "murosimf/dynamics/integrator.h"
#include "murosimf/dynamics/joint_reference.h"
#include "murosimf/dynamics/pose_columns.h"
#include "murosimf/multibody/integrate.h"
#include "murosimf/multibody/mass.h"
#include "murosimf/world/motion_level.h"

namespace murosimf::dynamics {

struct SimplifiedDynamicsOptions {
  Integrator integrator = Integrator::semi_implicit_euler;
  bool base_rigid = false;  ///< the paper's literal reading
  JointReferenceOptions reference;
};

class SimplifiedDynamics final : public MotionLevel, private collision::ImpulseResponse {
 public:
  static constexpr LevelTraits has{.dynamic = true};

  /// Throws SetupError if the model has no mass.
  explicit SimplifiedDynamics(Setup& setup, const SimplifiedDynamicsOptions& options = {});

  [[nodiscard]] LevelTraits traits() const override { return has; }
  void initialize() override;
  void step(const Instant& instant) noexcept override;
  [[nodiscard]] Momentum hand_over() noexcept override;
  /// The base turns from now on as a rigid body with this angular momentum does.
  void take_over(const Momentum& momentum) override;
  [[nodiscard]] bool goes_with(const Algorithm& other) const override;
  [[nodiscard]] std::unique_ptr<LaneGroup> join(std::span<Algorithm* const> members) const override;

 private:
  friend class RigidLanes;

  /// Motion of the body and the base's attitude in a step.
  struct Course {
    multibody::FreeBody<double> body;
    Vec3d angular_momentum;  // [N m s] about the center of mass
    bool sane = false;       // false: the entity was frozen
  };
  [[nodiscard]] bool free_pass(double dt) noexcept override;
  [[nodiscard]] std::size_t coordinates() const noexcept override { return 6; }
  [[nodiscard]] Vec3d free_velocity(int object, const Vec3d& point, const Vec3d& velocity) const noexcept override;
  void respond(int object, const Vec3d& point, const Mat3d& directions,
               collision::ResponseRows& y) const noexcept override;
  void apply(std::span<const double> z) noexcept override;

  void check() const;
  void step_rk4(double dt) noexcept;
  [[nodiscard]] Course find_course(const Instant& instant) noexcept;
  void turn(const multibody::FreeBody<double>& body) noexcept;
  void begin_step(double dt) noexcept;
  void solve(double dt) noexcept;
  [[nodiscard]] Vec3d next_velocity(const Vec3d& point, const Vec3d& velocity) const noexcept;
  void predict_contacts() noexcept;
  void step_fixed(double dt) noexcept;
  /// Keeps the base at rest at its place; all else follows from the joints.
  void follow_fixed_base() noexcept;
  /// Moment [N m] of external forces about the center of mass in the present step.
  [[nodiscard]] Vec3d outer_moment() const noexcept;
  [[nodiscard]] bool in_flight() const noexcept;
  void follow_center(const multibody::FreeBody<double>& body, const Vec3d& angular_momentum) noexcept;
  void follow_base(const multibody::FreeBody<double>& body, const Mat3d& R_before) noexcept;
  void store_common_body(const multibody::CommonBody<double>& common) noexcept;
  void halt(const char* reason) noexcept;

  Entity& entity_;
  SimplifiedDynamicsOptions options_;
  bool fixed_;     // the base is bolted to the world
  double period_;  // [s]
  Vec3d gravity_;
  PoseColumns columns_;
  JointReference reference_;
  std::span<Wrenchd> external_force_;
  std::span<Sym6d> external_damping_;
  const Vec3d& separation_;
  ContactTrials contacts_;
  Vec3d& center_;      // [m] common center of mass, world
  Vec3d& velocity_;    // [m/s] of the center of mass
  SymMat3d& inertia_;  // [kg m^2] at the center of mass, world axes
  double& mass_;       // [kg]
  double& dynamic_;
  Sym6d matrix_;                             // inertia and external damping at the center of mass
  std::optional<Cholesky6<double>> factor_;  // of it, for responses
  Twistd acceleration_;                      // [rad/s^2; m/s^2] of the center of mass in the present step
  RungeKutta4 runge_kutta_;
  std::vector<double> row_;        // the state while Runge-Kutta works on it
  double dt_ = 0;                  // [s] of the present step
  bool pushed_in_island_ = false;  // in the present step; a robot alone in its island flies as others do
};

}  // namespace murosimf::dynamics
