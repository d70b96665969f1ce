/// impulse_response.h - interface of levels to island solvers: the change of an entity's motion due to contacts.
///
/// The level solves its step once without contacts (free_pass). The effect of an impulse is linear: the level's
/// factorization M = F F^T gives for every direction J of a contact point the vector y = F^-1 J^T, so that J M^-1 J^T = y . y, and
/// the effect of all impulses together follows from z = sum y lambda. Most numbers of y are zero: those of joints that are
/// not between the base and the body.
/// Source: Featherstone 2008, sec. 6.5 (branch-induced sparsity of the factors); the articulated-body algorithm
/// provides them without the matrix.
#pragma once

#include <span>
#include <vector>

#include "murosimf/math/assert.h"
#include "murosimf/math/four.h"
#include "murosimf/math/spatial.h"

namespace murosimf::collision {

/// Vectors y of three directions at one point: the numbers that are not zero in all of them.
struct ResponseRows {
  std::vector<int> index;    ///< which number of z
  std::vector<Vec3d> value;  ///< [1/sqrt(kg)] of the three directions

  void add(int i, const Vec3d& numbers) {
    MUROSIMF_ASSERT(i >= 0 && index.size() == value.size());
    index.push_back(i);
    value.push_back(numbers);
  }
};

/// Three forces side by side.
using ThreeForces = Wrench<Four>;

/// The three numbers of a row.
[[nodiscard]] inline Vec3d first_three(const Four& row) noexcept { return {row[0], row[1], row[2]}; }

/// Forces [N m, N] of 1 N along each column of `directions`, at `arm` [m] from the point about which moments are taken.
[[nodiscard]] inline ThreeForces unit_forces(const Vec3d& arm, const Mat3d& directions) noexcept {
  const auto& [a, b, c] = directions;
  const Vec3<Four> force{{a.x, b.x, c.x, 0.0}, {a.y, b.y, c.y, 0.0}, {a.z, b.z, c.z, 0.0}};
  return {cross(arm, force), force};
}

/// Appends numbers 0 to 5 of y: of a rigid body with the factored inertia F F^T under three forces.
inline void add_rigid_response(const Cholesky6<double>& factor, const ThreeForces& forces, ResponseRows& y) {
  const auto rows = factor.forward(forces);
  for (int i = 0; i < 6; ++i) y.add(i, first_three(rows[static_cast<std::size_t>(i)]));
}

class ImpulseResponse {
 public:
  virtual ~ImpulseResponse() = default;

  /// Solves the step of `dt` [s] with the present external_force and external_damping, and keeps the factorization.
  /// False if the result is not sane: the entity freezes in its own step, and must not touch others in this
  /// one.
  [[nodiscard]] virtual bool free_pass(double dt) noexcept = 0;
  /// Number of coordinates of z.
  [[nodiscard]] virtual std::size_t coordinates() const noexcept = 0;
  /// Velocity [m/s] after the free step of a point [m] of a body that has `velocity` [m/s] now; world frame.
  [[nodiscard]] virtual Vec3d free_velocity(int object, const Vec3d& point, const Vec3d& velocity) const noexcept = 0;
  /// Appends y of unit forces along the columns of `directions` at `point` [m] of a body; world frame. Each index at most
  /// once.
  virtual void respond(int object, const Vec3d& point, const Mat3d& directions, ResponseRows& y) const noexcept = 0;
  /// Adds the impulses with sum z [N s/sqrt(kg)] to the free step, which the level executes next.
  virtual void apply(std::span<const double> z) noexcept = 0;
};

}  // namespace murosimf::collision
