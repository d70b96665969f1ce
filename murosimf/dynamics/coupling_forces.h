/// coupling_forces.h - what holds coupled joints together, and loops closed, where they are moved by forces: a stiff spring and a
/// damper between follower f and leader l, with the ratio r, or the leaders of a tendon (joint_tendon.h) with their coefficients,
///
///     e = q_f - offset - sum r_l q_l,   torque on f = lambda = -k e - d e',   torque on l = -r_l lambda
///
/// settled for the end of the step, implicit Euler of both together: with J e' = J (qd + h qdd) the rate of e after a
/// step without a change of lambda, and A = J M^-1 J^T from the factors of the articulated-body algorithm,
///
///     (A + C) h dlambda = -(e' + e / (h + d/k) + C h lambda),   C = 1 / (h^2 k + h d)
///
/// Where a position follows by a curve, q_f = L(q) of a spatial tendon (spatial_tendon.h) or a tie of tendons (tendon_tie.h), r and offset
/// are those of its tangent at the beginning of the step; what the curve departs from it within a step is part of the next one's e.
/// A joint that friction holds has no part in A. k = T / 0.2 mrad (T / 0.02 mm) at the follower, T the largest of both
/// servos' stall torques there and the robot's weight times 0.1 m (its weight, for a slider), and at least a thousand times the stiffness
/// of a tendon's own spring and servo; d = k * 0.5 ms. Ties of tendons have the k of their first tendon.
/// The rows of loops (multibody/loop_rows.h) are such springs, too, settled in the same system: e is the gap, and e' its mean rate over
/// the step, J (qd + h qdd) + h/2 (dJ/dt) qd, so that e + h e' is the gap at its end to second order. That is SHAKE with a soft
/// constraint: it has the force at the place where the step begins and the gap where it ends, and the slow motion of a linkage neither
/// gains nor loses energy. k = weight / 0.02 mm for a shift, 0.1 m times the weight over 0.2 mrad for a turn, so that a loop that is
/// held more than once, by hinges that are parallel up to the digits of a file, is not locked. A gap closes with 0.5 m/s (5 rad/s) at
/// most: a robot that is assembled wrongly is not torn apart.
///
/// A follower that moves no inertia has the trace 1e-6 / sum(r_l^2 / J_l) of its leaders' inertias J, a tendon 1e-3: the factors need some,
/// and the coupling, which is settled with it, makes the leaders one part in a million heavier, along a tendon one in a thousand: with
/// less, whether its friction slips is decided anew in every pass; the rate to which friction lets it slip is predicted with what it takes
/// along. A spatial tendon counts as one that moves no more than the robot's mass, so that its slider stays light where no joint changes
/// its length.
/// Impulses inside an island come after that. What holds answers them in the same step: with y = F^-1 Jc^T of a contact and R = F^-1 J^T of
/// the rows, whose inverse mass is then 1 - R (A + C)^-1 R^T between F^-1 and F^-T, an impulse has the numbers
///
///     y - R c,  sqrt(C) c      c = (A + C)^-1 R^T y
///
/// whose products are those of that matrix. -c times the impulse is added to h lambda.
/// Source: Featherstone 2008, sec. 6.5 (factors), 8.12 (constraint forces, loop joints); soft constraints as in
/// Catto, Soft Constraints, GDC 2011; Hairer, Lubich, Wanner, Geometric Numerical Integration, sec. VII.1 (SHAKE).
#pragma once

#include <span>
#include <vector>

#include "murosimf/collision/contact_laws/impulse_response.h"
#include "murosimf/dynamics/coupling_rods.h"
#include "murosimf/dynamics/moving_tree.h"
#include "murosimf/math/assert.h"
#include "murosimf/multibody/articulated_body.h"
#include "murosimf/multibody/friction_solver.h"
#include "murosimf/multibody/loop_joints.h"
#include "murosimf/multibody/loop_rows.h"

namespace murosimf::dynamics {

class CouplingForces {
 public:
  /// Adds the properties coupling_torque and loop_force, if the model has coupled joints or loops. Throws SetupError as MimicJoints
  /// and loops_of do.
  explicit CouplingForces(Setup& setup);

  [[nodiscard]] bool empty() const { return joints_.empty() && loops_.empty(); }
  /// Moves the passive joints of loops to where the loops close, then tendons to where their joints say.
  void assemble(PoseColumns& columns);
  /// Sets all torques to zero.
  void start() noexcept;

  /// `moved`: inertias [kg m^2 | kg] that the joints move by themselves, by link. A follower that moves none counts as a part of its
  /// leader, and moves in `moved` what that one does, at its ratio.
  /// q: positions [rad | m] by object.
  void count_at_leaders(std::span<const double> q, std::span<double> moved);
  /// To be called first in a step: how curves run at the present positions. Where joints were put elsewhere from outside, tendons that are
  /// far from where these say go there, since they have no place of their own.
  void take_up(PoseColumns& columns) noexcept;
  /// To be called in each step, too: how loops stand.
  void look(const MovingTree& tree) noexcept;
  /// Adds the present forces of loops to the loads of their links.
  void add_loads(std::span<multibody::ArticulatedLink<double>> bodies) const noexcept;
  /// Adds the present torques to the drives of the joints; by link.
  void drive(std::span<multibody::FrictionalJoint<double>> joints) const noexcept;
  /// The change of the torques, as the numbers z [N s/sqrt(kg)] of an impulse response (collision/contact_laws/impulse_response.h); for
  /// a step of h [s] > 0 without a change. `bodies` with their accelerations and factors, roots: of inverse_D, by link.
  [[nodiscard]] std::span<const double> solve(const MovingTree& tree,
                                              std::span<const multibody::ArticulatedLink<double>> bodies,
                                              std::span<const double> roots, double h) noexcept;
  /// Moves the change from the loads of the joints to their drives, after it has been applied as a load.
  void count_as_drive(std::span<multibody::FrictionalJoint<double>> joints) noexcept;

  /// Number of coordinates of responses beyond those of the tree.
  [[nodiscard]] std::size_t size() const { return rods_.size() + loops_.rows().size(); }
  /// To be called after solve(), for the two below.
  void prepare_responses() noexcept;
  /// Converts the numbers of a response from `first` on, which are those of the tree alone, to those of the tree with its couplings.
  void hold(collision::ResponseRows& y, std::size_t first) const noexcept;
  /// Effect of the impulses z on the tree with its couplings, as numbers of the tree alone; call count_as_drive afterwards.
  [[nodiscard]] std::span<const double> held(std::span<const double> z) noexcept;

 private:
  [[nodiscard]] std::span<CouplingRod> tendon_rods() noexcept {
    return std::span(rods_).subspan(joints_.pairs().size(), joints_.tendons().size());
  }
  [[nodiscard]] std::span<CouplingRod> ties() noexcept { return std::span(rods_).last(joints_.ties().size()); }
  /// [N m | N] lambda of a rod, in its column.
  [[nodiscard]] double& force_of(const CouplingRod& rod) const noexcept {
    return (rod.tie ? tie_force_ : torque_)[rod.follower.object];
  }
  [[nodiscard]] double& force_of(const multibody::LoopRow& row) const noexcept;
  [[nodiscard]] double stiffness_of(const multibody::LoopRow& row) const noexcept {
    return row.is_turn() ? turn_stiffness_ : shift_stiffness_;
  }
  void fill_rows(const MovingTree& tree, std::span<const multibody::ArticulatedLink<double>> bodies,
                 std::span<const double> roots) noexcept;
  void fill_row(std::size_t rod, const MovingTree& tree, std::span<const multibody::ArticulatedLink<double>> bodies,
                std::span<const double> roots) noexcept;
  [[nodiscard]] std::span<const double> row(std::size_t i) const noexcept {
    MUROSIMF_ASSERT(i < size());
    return {rows_.data() + i * coordinates_, coordinates_};
  }
  void fill_matrix(std::size_t i, double softness) noexcept;
  void factor() noexcept;
  void solve_factored(std::span<double> x) const noexcept;
  void add_response(int link, double torque, Wrenchd force, const MovingTree& tree,
                    std::span<const multibody::ArticulatedLink<double>> bodies, std::span<const double> roots,
                    std::span<double> row) const noexcept;
  void fill_right_side(const MovingTree& tree, std::span<const multibody::ArticulatedLink<double>> bodies,
                       double h) noexcept;

  MimicJoints joints_;
  multibody::LoopRows loops_;
  multibody::LoopJoints followers_;
  std::span<double> torque_;       // [N m | N] lambda, by object
  std::span<double> tie_force_;    // [N] the same of ties, by object of the follower
  std::span<Wrenchd> loop_force_;  // [N m, N] the same of loops
  double shift_stiffness_ = 0;     // [N/m] k
  double turn_stiffness_ = 0;      // [N m/rad]
  double mass_ = 0;                // [kg] of the robot
  std::vector<double> moved_;      // [kg m^2 | kg] inertia that each joint moves by itself, by link
  std::vector<CouplingRod> rods_;  // of each pair, then of each tendon, then of each tie
  std::size_t coordinates_ = 0;
  std::vector<double> rows_;    // F^-1 J^T, of rod i at i * coordinates; then those of loops
  std::vector<double> matrix_;  // A + C, i and j at i * size() + j; then its Cholesky factor
  std::vector<double> change_;  // [N m s | N s] right side, then h dlambda
  std::vector<double> z_;
  std::vector<double> softness_;       // C
  std::vector<double> answers_;        // (A + C)^-1 R^T, of row i at i * coordinates
  mutable std::vector<Vec3d> dense_;   // of a response; working memory
  mutable std::vector<Vec3d> answer_;  // c
  double h_ = 0;                       // [s] of the present step
};

}  // namespace murosimf::dynamics
