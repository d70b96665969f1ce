/// interpenetration.h - entities whose bodies have gone deep into each other or through each other, each pair once.
///
/// Soft contact keeps bodies apart only if it is stiff enough for their masses and the step. Beyond half of the thinner one's
/// thickness the shortest way out is on the far side, and contact pushes them through each other:
///
///     too deep   depth > min(thickness of A, thickness of B) / 2
///     crossed    the normal of their shapes has turned round since the step before: n . n_before < -1/2
///
///     fast       |v| dt > min(thickness of A, thickness of B) / 2, of points that are let out slowly: it came beyond the middle
///
/// Points that are let out slowly (depenetration.h) count only if they came with more than half of that thickness in a step: others were put
/// there. What would jump over something between two steps is stopped there (continuous_collision.h).
#pragma once

#include <span>
#include <vector>

#include "murosimf/model/shape.h"
#include "murosimf/world/time.h"

namespace murosimf {
class StateArchive;
}  // namespace murosimf

namespace murosimf::collision {

struct ContactPoint;
struct MovingEntity;
struct PairContact;
struct PairSet;

/// Plain data.
struct Interpenetration {
  int a = 0, b = 0;                 ///< numbers of the entities in the world (World::index_of); equal: limbs of one
  int object = 0, object_b = 0;     ///< bodies of either
  double depth = 0, thickness = 0;  ///< [m] of the contact; of the thinner shape
  bool crossed = false;
  Duration time{};
};

void state(StateArchive& archive, Interpenetration& one);

[[nodiscard]] constexpr bool is_of(const Interpenetration& one, int a, int b) {
  return (one.a == a && one.b == b) || (one.a == b && one.b == a);
}

/// [m] smallest distance of two parallel planes that hold the shape between them; of a polyhedron, of planes along its faces.
/// Infinite for a plane.
[[nodiscard]] double thickness(const Shape& shape);

/// How a point is found.
enum class Depth { usual, too_deep, through };
/// `dt` [s] of the step. `turned`: the normal has turned round.
[[nodiscard]] Depth depth_of(const ContactPoint& point, double thickness, double dt, bool turned) noexcept;
/// Of the normals of a contact in two successive steps.
[[nodiscard]] inline bool have_turned(const Vec3d& before, const Vec3d& now) { return dot(before, now) < -0.5; }

/// Adds pairs of entities that are not in set.interpenetrations yet. After the points of the step have been found; set.previous has
/// those of the step before.
void note_interpenetrations(std::span<const MovingEntity> moving_entities, double dt, Duration now, PairSet& set);

}  // namespace murosimf::collision
