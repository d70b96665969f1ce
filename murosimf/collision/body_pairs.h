/// body_pairs.h - contacts between entities that move, and where their shapes touch.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "murosimf/collision/contact.h"
#include "murosimf/model/shape.h"

namespace murosimf::collision {

/// A contact point of two entities: A (`object`) feels +force, B feels -force.
struct PairContact : ContactPoint {
  int a = 0, b = 0;              ///< which entities, as indices into the list that the algorithm was given; a < b
  int object_b = 0;              ///< body of B
  std::uint64_t key = 0;         ///< which shapes; stays the same from step to step
  Vec3d arm_a, arm_b;            ///< [m] from the origin of either body to the point, world axes
  Vec3d velocity_a, velocity_b;  ///< [m/s] of the point on either body, world frame
};

/// All contacts between moving entities. One value, in a column of the field.
struct PairSet {
  std::vector<PairContact> points;            ///< sorted by key
  std::vector<ContactParameters> parameters;  ///< by Contact::surface
  std::vector<PairContact> previous;          ///< of the step before; working memory
};

void append_hash(Hasher& hasher, const PairSet& set);

inline constexpr Property<PairSet> pair_contacts{
    {"pair_contacts", "-", "world", "points where moving bodies touch each other", Scope::base}};

/// A shape in the world.
struct PlacedInWorld {
  const Shape* shape = nullptr;
  Vec3d position;     ///< [m] of the shape's own frame
  Mat3d orientation;  ///< its axes to world axes
};

/// True if `find_touch` can say something about two shapes: if one is a sphere, or both are capsules.
[[nodiscard]] bool can_touch(const Shape& a, const Shape& b);

/// Deepest point where two shapes overlap.
struct Touch {
  Vec3d point;       ///< [m] world frame, in the middle of the overlap
  Vec3d normal;      ///< [1] unit, world frame, from B to A
  double depth = 0;  ///< [m] positive
};
[[nodiscard]] std::optional<Touch> find_touch(const PlacedInWorld& a, const PlacedInWorld& b);

}  // namespace murosimf::collision
