/// simplified_dynamics.h - level `simplified_dynamics`: the robot moves as one rigid body with its common mass,
/// center of mass and inertia; joints follow their targets.
///
///     m vc' = m g + sum f            I w' + w x I w = sum ((r - c) x f + n)
///
/// External forces enter implicitly through their damping D (contact.h): (diag(I, m) + dt D_c) a = forces at the
/// beginning of the step, with D_c the damping of all bodies moved to the center of mass. A ball is the same thing
/// with a single object.
///
/// What a joint motion does to the base:
///  * center-continuous (default): c and vc are integrated, the base follows from them: r_0 = c - R c_B(q),
///    v_0 = vc - w x R c_B - R c_B'. Limbs moving in free flight do not move the center of mass.
///  * base-rigid (the paper's literal reading): the base is integrated as part of the rigid body, limbs then move the
///    center of mass (55 mm in the project's flight test).
/// Joint motion never turns the base: that is the simplification; `full_dynamics` has it.
/// Source: paper 4.2.
#pragma once

#include <optional>
#include <vector>

#include "murosimf/collision/impulse_response.h"
#include "murosimf/model/motion_level.h"
#include "murosimf/motion/contact_trials.h"
#include "murosimf/motion/integrator.h"
#include "murosimf/motion/joint_reference.h"
#include "murosimf/motion/pose_columns.h"
#include "murosimf/multibody/integrate.h"
#include "murosimf/multibody/mass.h"

namespace murosimf::motion {

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

 private:
  [[nodiscard]] bool free_pass(double dt) noexcept override;
  [[nodiscard]] std::size_t coordinates() const noexcept override { return 6; }
  [[nodiscard]] Vec3d free_velocity(int object, const Vec3d& point, const Vec3d& velocity) const noexcept override;
  void respond(int object, const Vec3d& point, const Mat3d& directions,
               collision::ResponseRows& y) const noexcept override;
  void apply(std::span<const double> z) noexcept override;

  void check() const;
  void step_rk4(double dt) noexcept;
  void begin_step(double dt) noexcept;
  void solve(double dt) noexcept;
  [[nodiscard]] Vec3d next_velocity(const Vec3d& point, const Vec3d& velocity) const noexcept;
  void predict_contacts() noexcept;
  void follow_center(const multibody::FreeBody<double>& body) noexcept;
  void follow_base(const multibody::FreeBody<double>& body, const Mat3d& R_before) noexcept;
  void store_common_body(const multibody::CommonBody<double>& common) noexcept;
  void halt(const char* reason) noexcept;

  Entity& entity_;
  SimplifiedDynamicsOptions options_;
  double period_;  // [s]
  Vec3d gravity_;
  PoseColumns columns_;
  JointReference reference_;
  std::span<Wrenchd> external_force_;
  std::span<Sym6d> external_damping_;
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
  std::vector<double> row_;  // the state while Runge-Kutta works on it
  double dt_ = 0;            // [s] of the present step
};

}  // namespace murosimf::motion
