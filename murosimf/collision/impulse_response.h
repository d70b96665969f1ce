/// impulse_response.h - what an island solver asks of whatever moves an entity: how contacts would change its motion.
///
/// The level solves its step once without contacts (free_pass). What an impulse then adds is linear: the level's
/// factorization M = F F^T gives for every direction J of a contact point the vector y = F^-1 J^T, so that J M^-1 J^T = y . y, and
/// what all impulses together do is known from z = sum y lambda. Most numbers of y are zero: those of joints that are
/// not between the base and the body.
/// Source: Featherstone 2008, sec. 6.5 (branch-induced sparsity of the factors); the articulated-body algorithm
/// provides them without the matrix.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "murosimf/math/spatial.h"

namespace murosimf::collision {

/// Vectors y of three directions at one point: the numbers that are not zero for all of them.
struct ResponseRows {
  std::vector<int> index;    ///< which number of z
  std::vector<Vec3d> value;  ///< [1/sqrt(kg)] of the three directions

  void add(int i, const Vec3d& numbers) {
    index.push_back(i);
    value.push_back(numbers);
  }
};

/// Forces [N m, N] of 1 N along each column of `directions`, at `arm` [m] from the point about which moments are taken.
[[nodiscard]] inline std::array<Wrenchd, 3> unit_forces(const Vec3d& arm, const Mat3d& directions) noexcept {
  const auto& [a, b, c] = directions;
  return {Wrenchd{cross(arm, a), a}, Wrenchd{cross(arm, b), b}, Wrenchd{cross(arm, c), c}};
}

/// Appends numbers 0 to 5 of y: of a rigid body with the factored inertia F F^T under three forces.
inline void add_rigid_response(const Cholesky6<double>& factor, const std::array<Wrenchd, 3>& forces, ResponseRows& y) {
  const auto a = factor.forward(forces[0]), b = factor.forward(forces[1]), c = factor.forward(forces[2]);
  for (int i = 0; i < 6; ++i) y.add(i, {a[i], b[i], c[i]});
}

class ImpulseResponse {
 public:
  virtual ~ImpulseResponse() = default;

  /// Solves the step of `dt` [s] with the present external_force and external_damping, and keeps the factorization.
  /// False if that gives no sensible numbers: the entity freezes in its own step, and must not touch others in this
  /// one.
  [[nodiscard]] virtual bool free_pass(double dt) noexcept = 0;
  /// How many numbers z has.
  [[nodiscard]] virtual std::size_t coordinates() const noexcept = 0;
  /// Velocity [m/s] after the free step of a point [m] of a body that has `velocity` [m/s] now; world frame.
  [[nodiscard]] virtual Vec3d free_velocity(int object, const Vec3d& point, const Vec3d& velocity) const noexcept = 0;
  /// Appends y of unit forces along the columns of `directions` at `point` [m] of a body; world frame. Each index at most
  /// once.
  virtual void respond(int object, const Vec3d& point, const Mat3d& directions, ResponseRows& y) const noexcept = 0;
  /// Adds the impulses with sum z [N s/sqrt(kg)] to the free step: the step that the level is about to make.
  virtual void apply(std::span<const double> z) noexcept = 0;
};

}  // namespace murosimf::collision
