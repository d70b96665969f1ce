/// effective_mass.h - how easily what is touched yields: the velocity that an impulse gives it, at most.
///
/// An entity whose joints are given is one rigid body. Of one whose joints torques move, every link counts as if it were free:
///
///     1/m + (d x u)^T J^-1 (d x u)     of the point at d from the center of mass along the unit vector u, by 1 N s
///     u^T J^-1 u                       of the turning rate about u, by 1 N m s
///
/// Joints hold a link back and never help it, so this is an upper bound. What several contacts rub at the same time gets their
/// number times as much: n forces f_i on one part give it the energy |sum J_i^T f_i|^2 / 2 in the metric of its inverse
/// inertia, at most n sum |J_i^T f_i|^2 / 2 (Cauchy and Schwarz).
/// Source: Gauss's principle of least constraint: constraints take from the mobility J M^-1 J^T, in every direction.
#pragma once

#include <vector>

#include "murosimf/collision/moving_entity.h"

namespace murosimf::collision {

class EffectiveMass {
 public:
  /// Of a part; `none` for one that cannot be pushed.
  using Number = int;
  static constexpr Number none = -1;

  /// Forgets all parts: poses are new.
  void start() noexcept { parts_.clear(); }
  /// One more contact of a body of the entity with this number; returns its part.
  Number touch(const MovingEntity& moving_entity, int number, int object);

  /// [1/kg] of a point [m] along a unit vector, times the contacts of the part; world frame. 0 for `none`.
  [[nodiscard]] double along(Number part, const Vec3d& point, const Vec3d& direction) const noexcept;
  /// [1/(kg m^2)] about a unit vector, times the contacts of the part; world axes. 0 for `none`.
  [[nodiscard]] double about(Number part, const Vec3d& direction) const noexcept;

 private:
  struct Part {
    int entity, link;  // link 0 if it is the whole entity
    int contacts;
    double mass;               // [kg]
    Vec3d center;              // [m] of mass, world
    SymMat3d inverse_inertia;  // [1/(kg m^2)] at the center of mass, world axes
  };
  std::vector<Part> parts_;
};

}  // namespace murosimf::collision
