/// coupling_forces.h - what holds coupled joints together where they are moved by forces: a stiff spring and a damper
/// between follower f and leader l, with the ratio r,
///
///     e = q_f - offset - r q_l,   torque on f = lambda = -k e - d e',   torque on l = -r lambda
///
/// settled for the end of the step, implicit Euler of both together: with J e' = J (qd + h qdd) the rate of e after a
/// step without a change of lambda, and A = J M^-1 J^T from the factors of the articulated-body algorithm,
///
///     (A + C) h dlambda = -(e' + e / (h + d/k) + C h lambda),   C = 1 / (h^2 k + h d)
///
/// A joint that friction holds has no part in A. k = T / 0.2 mrad (T / 0.02 mm) at the follower, T the largest of both
/// servos' stall torques there and the robot's weight times 0.1 m (its weight, for a slider); d = k * 0.5 ms.
/// Forces of contacts inside an island come after lambda; the next step answers them, so that a contact that gives e the
/// acceleration a by itself stretches the coupling by a h (h + d/k) more.
/// Source: Featherstone 2008, sec. 6.5 (factors), 8.12 (constraint forces, loop joints); soft constraints as in
/// Catto, Soft Constraints, GDC 2011.
#pragma once

#include <span>
#include <vector>

#include "murosimf/motion/mimic_joints.h"
#include "murosimf/motion/moving_tree.h"
#include "murosimf/multibody/articulated_body.h"
#include "murosimf/multibody/friction_solver.h"

namespace murosimf::motion {

class CouplingForces {
 public:
  /// Adds the property coupling_torque, if the model has coupled joints. Throws SetupError as MimicJoints does.
  explicit CouplingForces(Setup& setup);

  [[nodiscard]] const MimicJoints& joints() const { return joints_; }
  [[nodiscard]] bool empty() const { return joints_.empty(); }
  /// No torque yet.
  void start() noexcept;

  /// Adds the torques that there are to what drives the joints; by link.
  void drive(std::span<multibody::FrictionalJoint<double>> joints) const noexcept;
  /// How the torques change, as the numbers z [N s/sqrt(kg)] of an impulse response (collision/impulse_response.h); for
  /// a step of h [s] without a change. `bodies` with their accelerations and factors, roots: of inverse_D, by link.
  [[nodiscard]] std::span<const double> solve(const MovingTree& tree,
                                              std::span<const multibody::ArticulatedLink<double>> bodies,
                                              std::span<const double> roots, double h) noexcept;
  /// After the change has been applied as a load of the joints: from now on it drives them.
  void count_as_drive(std::span<multibody::FrictionalJoint<double>> joints) noexcept;

 private:
  struct Rod {
    int follower = 0, leader = 0;  // links
    double stiffness = 0;          // [N m/rad | N/m] k
  };
  void fill_row(std::size_t pair, const MovingTree& tree, std::span<const multibody::ArticulatedLink<double>> bodies,
                std::span<const double> roots) noexcept;
  void add_response(int link, double torque, const MovingTree& tree,
                    std::span<const multibody::ArticulatedLink<double>> bodies, std::span<const double> roots,
                    std::span<double> row) const noexcept;
  void fill_right_side(const MovingTree& tree, std::span<const multibody::ArticulatedLink<double>> bodies,
                       double h) noexcept;
  void solve_pairs() noexcept;

  MimicJoints joints_;
  std::span<double> torque_;  // [N m | N] lambda, by object
  std::vector<Rod> rods_;     // of each pair
  std::size_t coordinates_ = 0;
  std::vector<double> rows_;    // F^-1 J^T, of pair i at i * coordinates
  std::vector<double> matrix_;  // A + C, i and j at i * pairs + j; then its Cholesky factor
  std::vector<double> change_;  // [N m s | N s] right side, then h dlambda
  std::vector<double> z_;
  double h_ = 0;  // [s] of the present step
};

}  // namespace murosimf::motion
