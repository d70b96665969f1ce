/// impulse_response.h - what an island solver asks of whatever moves an entity: how contacts would change its motion.
///
/// The level solves its step once without contacts (free_pass). What an impulse then adds is linear: the level's
/// factorization M = F F^T gives for every direction J of a contact point the vector y = F^-1 J^T, so that J M^-1 J^T = y . y, and
/// what all impulses together do is known from z = sum y lambda. Most numbers of y are zero: those of joints that are
/// not between the base and the body.
/// Source: Featherstone 2008, sec. 6.5 (branch-induced sparsity of the factors); the articulated-body algorithm
/// provides them without the matrix.
#pragma once

#include <span>
#include <vector>

#include "murosimf/math/spatial.h"

namespace murosimf::collision {

/// A vector y with few numbers.
struct ResponseRow {
  std::vector<int> index;
  std::vector<double> value;

  void clear() {
    index.clear();
    value.clear();
  }
  void add(int i, double number) {
    index.push_back(i);
    value.push_back(number);
  }
  [[nodiscard]] double times(std::span<const double> z) const {
    double sum = 0;
    for (std::size_t k = 0; k < index.size(); ++k) sum += value[k] * z[index[k]];
    return sum;
  }
  void add_to(std::span<double> z, double lambda) const {
    for (std::size_t k = 0; k < index.size(); ++k) z[index[k]] += lambda * value[k];
  }
};

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
  /// y [1/sqrt(kg)] of a unit force along `direction` at `point` [m] of a body; world frame.
  virtual void respond(int object, const Vec3d& point, const Vec3d& direction, ResponseRow& y) const noexcept = 0;
  /// Adds the impulses with sum z [N s/sqrt(kg)] to the free step: the step that the level is about to make.
  virtual void apply(std::span<const double> z) noexcept = 0;
};

}  // namespace murosimf::collision
