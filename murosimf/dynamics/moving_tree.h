/// moving_tree.h - common part of the levels that simulate every link: state, forces on links, contacts, the base's motion.
///
/// Accelerations are those of link_motion.h: of a link, about the origin O of the base, b + [0; g] + a' with a' the part
/// that the level solves for. A body k at d from O on link l, with external force F and external damping D at its
/// origin (contact.h), is subject to
///
///     F - h D [alpha; a_k],   alpha = w',   a_k = v' + w' x d + w x v_k       [w'; v'] = b + [0; g] + a'
///
/// that is, a constant force about O and a matrix h D about O that multiplies a'. a_k is the acceleration of the body's
/// material origin; the velocity of a contact point x after the step is v_x + h (a_k + alpha x (x - r_k)).
/// The base: v_0 += h a_0 in world axes, r_0 += h v_0, w += h alpha, Q = exp(h w) Q (multibody/integrate.h).
///
/// Momentum correction: semi-implicit Euler keeps momentum to first order only. In a step without any contact, the
/// base's place and velocity are afterwards set so that momentum, moment of momentum about the center of mass, and the
/// center's path are exactly the initial ones plus the contributions of gravity and pushes. The base then turns with the rate in the
/// middle of the step, Q = exp(h (w + h alpha / 2)) Q: with the rate at its end, which the correction reverts, a
/// free body would gain energy (15 % in 10 s of a flipping body at 10 rad/s).
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "murosimf/collision/contact_laws/impulse_response.h"
#include "murosimf/dynamics/contact_trials.h"
#include "murosimf/dynamics/free_state.h"
#include "murosimf/dynamics/integrator.h"
#include "murosimf/dynamics/pose_columns.h"
#include "murosimf/dynamics/sanity.h"
#include "murosimf/dynamics/written_state.h"
#include "murosimf/math/assert.h"
#include "murosimf/multibody/link_motion.h"

namespace murosimf::dynamics {

class TreeLanes;

struct MovingTreeOptions {
  friend bool operator==(const MovingTreeOptions&, const MovingTreeOptions&) = default;
  Integrator integrator = Integrator::semi_implicit_euler;
  bool fixed_base = false;          ///< the base is bolted to the world
  bool momentum_correction = true;  ///< in flight
};

class MovingTree {
  struct OwnLinks {
    std::span<const multibody::LinkMotion<double>> rows;
    const auto& operator()(int link) const { return rows[static_cast<std::size_t>(link)]; }
  };

 public:
  /// Throws SetupError if the model has no mass; `level` is for the message.
  MovingTree(Setup& setup, const MovingTreeOptions& options, std::string_view level);

  /// Places the robot; joint positions must be set. Throws SetupError if some axis has no inertia.
  void start();
  /// Continues from the columns instead, with the base's velocity that gives the whole robot `momentum`. Throws likewise.
  void take_over(const Momentum& momentum);
  /// Detaches from the contacts; returns the momentum.
  [[nodiscard]] Momentum hand_over() noexcept;
  /// All state is in columns, except whether changes are still to be taken over; the rest is computed again.
  void state(StateArchive& archive);
  /// To be called first in a step: takes over changes of the columns by others since the last one (written_state.h).
  void take_changes() noexcept;

  /// Calls add(link, force, damping) for every body with a load: Wrenchd [N m, N] at a' = 0 and Sym6d h D, both
  /// about O. motion_of(link) has `velocity` and `bias` of a link, as its LinkMotion does.
  template <class MotionOf, class Add>
  void for_loads(double dt, const MotionOf& motion_of, const Add& add) const noexcept;
  template <class Add>
  void for_loads(double dt, const Add& add) const noexcept {
    for_loads(dt, OwnLinks{links}, add);
  }

  /// Velocities of the contact points after the step; acceleration_of(link) is a' of a link.
  template <class MotionOf, class Acceleration>
  void predict_contacts(double dt, const MotionOf& motion_of, const Acceleration& acceleration_of) noexcept;
  template <class Acceleration>
  void predict_contacts(double dt, const Acceleration& acceleration_of) noexcept {
    predict_contacts(dt, OwnLinks{links}, acceleration_of);
  }

  /// a'_0 of the base for the force [N m, N] about O that accelerates `inertia`; zero acceleration if the base is fixed.
  [[nodiscard]] Twistd base_acceleration(const Sym6d& inertia, const Wrenchd& force) noexcept;
  /// Prepares the responses below, for the inertia of the last base_acceleration.
  void factor_base() noexcept;
  /// Unit forces at `point` [m] along the columns of `directions`, about O.
  [[nodiscard]] collision::ThreeForces forces_about_base(const Vec3d& point, const Mat3d& directions) const noexcept {
    return collision::unit_forces(point - columns.r[0], directions);
  }
  /// Numbers 0 to 5 of a response (collision/contact_laws/impulse_response.h): of forces about O that have arrived at the base.
  void respond_at_base(const collision::ThreeForces& forces, collision::ResponseRows& y) const noexcept;
  /// The same for one force, added to a row of all numbers.
  void respond_at_base(const Wrenchd& force, std::span<double> row) const noexcept;
  /// Change of a'_0 due to the impulses z (first six numbers).
  [[nodiscard]] Twistd base_change(std::span<const double> z, double dt) const noexcept;

  /// Velocity [m/s] after the step of a body's point [m] that has `velocity` now, for a' = `acceleration` of its link.
  [[nodiscard]] Vec3d next_velocity(int object, const Vec3d& point, const Vec3d& velocity, const Twistd& acceleration,
                                    double dt) const noexcept {
    Vec3d alpha;
    const Vec3d a = reference_acceleration(object, OwnLinks{links}, acceleration, alpha);
    return velocity + dt * (a + cross(alpha, point - columns.r[object]));
  }

  /// Advances the base by its a'. False, and nothing changed, if the result is not sane.
  [[nodiscard]] bool advance_base(const Twistd& acceleration, double dt) noexcept;
  /// Advances the base and all joints by Runge-Kutta. solve() computes the accelerations at the present columns: it
  /// returns a'_0 and provides qdd(joint object). False if the state is not sane.
  template <class Solve, class JointAcceleration>
  [[nodiscard]] bool advance_rk4(double dt, const Solve& solve, const JointAcceleration& qdd) noexcept;
  /// Whether the momentum is to be conserved: no contact holds the robot, and the correction is enabled.
  [[nodiscard]] bool is_in_flight() const noexcept;
  [[nodiscard]] bool is_free() const { return !options_.fixed_base; }
  [[nodiscard]] Integrator integrator() const { return options_.integrator; }
  /// Inertia of all links, about O.
  [[nodiscard]] const RigidInertia<double>& composite_inertia() const { return whole_; }
  /// To be called last in a step, unless lanes do it (TreeLanes::take_advanced): poses, velocities, links, common mass.
  void finish_step() noexcept;
  void halt(const char* reason) noexcept;

  /// Whether both trees may step in lanes (tree_lanes.h): copies of one model, free, and stepped in the same way.
  [[nodiscard]] bool goes_with(const MovingTree& other) const noexcept;

  PoseColumns columns;
  std::vector<multibody::LinkMotion<double>> links;
  std::span<Wrenchd> external_force;
  std::span<Sym6d> external_damping;
  ContactTrials contacts;
  const Vec3d gravity;  // [m/s^2]

 private:
  friend TreeLanes;

  struct CenterMotion : Momentum {
    Vec3d center;  // [m] common center of mass
  };
  void check_inertia() const;
  template <class MotionOf>
  [[nodiscard]] Vec3d reference_acceleration(int object, const MotionOf& motion_of, const Twistd& extra,
                                             Vec3d& alpha) const noexcept;
  [[nodiscard]] CenterMotion momentum() const noexcept;
  [[nodiscard]] CenterMotion momentum_after(double dt) const noexcept;
  void correct_momentum(const CenterMotion& wanted) noexcept;
  [[nodiscard]] multibody::FreeBody<double> base() const noexcept;
  void place_base(const multibody::FreeBody<double>& base) noexcept;
  void refresh() noexcept;
  void update_links() noexcept;
  void take_links_back() noexcept;

  Entity& entity_;
  MovingTreeOptions options_;
  double period_;  // [s]
  Vec3d& center_;
  Vec3d& center_velocity_;
  SymMat3d& common_inertia_;
  double& total_mass_;
  double& dynamic_;
  RungeKutta4 runge_kutta_;
  std::vector<double> start_row_;
  std::vector<double> row_;           // the state while Runge-Kutta works on it
  const TreeLanes* lanes_ = nullptr;  // lanes that have computed the links of the present state; null: none
  bool has_own_links_ = true;         // `links` holds them as well
  WrittenState written_;              // state at the last computation of poses, velocities and links
  RigidInertia<double> whole_;        // of the links
  Sym6d base_inertia_;
  std::optional<Cholesky6<double>> factor_;      // of it, for responses
  std::optional<CenterMotion> wanted_momentum_;  // after the present step, in flight
};

// ---- definitions ----

/// Acceleration [m/s^2] of a body's origin and its angular acceleration for a' = `extra` of its link.
template <class MotionOf>
Vec3d MovingTree::reference_acceleration(int object, const MotionOf& motion_of, const Twistd& extra,
                                         Vec3d& alpha) const noexcept {
  MUROSIMF_ASSERT(object >= 0 && object < columns.model.size());
  const auto& link = motion_of(columns.model.tree().link_of[object]);
  const Vec3d d = columns.r[object] - columns.r[0];
  const auto& [w, v] = link.velocity;
  alpha = link.bias.w + extra.w;
  return link.bias.v + gravity + extra.v + cross(alpha, d) + cross(w, v + cross(w, d));
}

template <class MotionOf, class Add>
void MovingTree::for_loads(double dt, const MotionOf& motion_of, const Add& add) const noexcept {
  MUROSIMF_ASSERT(dt >= 0);
  for (const int object : columns.model.bodies()) {
    const bool damped = !is_zero(external_damping[object]);
    if (!damped && is_zero(external_force[object])) continue;
    const Vec3d to_base = columns.r[0] - columns.r[object];
    Wrenchd force = external_force[object];
    Sym6d damping;
    if (damped) {
      damping = dt * external_damping[object];
      Twistd a;
      a.v = reference_acceleration(object, motion_of, {}, a.w);
      force -= damping * a;
      damping = moved(damping, to_base);
    }
    add(columns.model.tree().link_of[object], moved(force, to_base), damping);
  }
}

/// Points are in the order of their bodies: quantities of a body are computed once for all its points.
template <class MotionOf, class Acceleration>
void MovingTree::predict_contacts(double dt, const MotionOf& motion_of, const Acceleration& acceleration_of) noexcept {
  int object = -1;
  Vec3d a, alpha;
  contacts.predict([&](const collision::ContactPoint& c) {
    if (c.object != object) {
      object = c.object;
      a = reference_acceleration(object, motion_of, acceleration_of(columns.model.tree().link_of[object]), alpha);
    }
    return c.velocity + dt * (a + cross(alpha, c.point - columns.r[object]));
  });
}

template <class Solve, class JointAcceleration>
bool MovingTree::advance_rk4(double dt, const Solve& solve, const JointAcceleration& qdd) noexcept {
  MUROSIMF_ASSERT(dt > 0);
  wanted_momentum_.reset();
  write_state(base(), columns, row_);
  start_row_ = row_;
  runge_kutta_.step(row_, dt, [&](const std::vector<double>& y, std::vector<double>& dy) {
    place_base(read_state(y, columns));
    columns.update_poses();
    update_links();
    const Twistd acceleration = solve();
    write_rate(base(), {acceleration.w, acceleration.v + gravity}, columns, qdd, dy);
    if (options_.fixed_base) std::fill_n(dy.begin(), base_numbers, 0.0);
  });
  const bool sane = is_sane_state(row_);
  place_base(read_state(sane ? row_ : start_row_, columns));
  if (!sane) refresh();  // back to the initial state
  return sane;
}

}  // namespace murosimf::dynamics
