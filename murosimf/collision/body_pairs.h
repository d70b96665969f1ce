/// body_pairs.h - contacts between entities that move.
#pragma once

#include <cstdint>
#include <vector>

#include "murosimf/collision/contact.h"
#include "murosimf/collision/interpenetration.h"

namespace murosimf::collision {

/// A contact point of two bodies: A (`object`) feels +force, B feels -force. Both may be of one entity.
struct PairContact : ContactPoint {
  int a = 0, b = 0;              ///< which entities, as indices into the list that the algorithm was given; a <= b
  int object_b = 0;              ///< body of B
  std::uint64_t shapes = 0;      ///< which shapes; with `feature` it stays the same from step to step
  Vec3d arm_a, arm_b;            ///< [m] from the origin of either body to the point, world axes
  Vec3d velocity_a, velocity_b;  ///< [m/s] of the point on either body, world frame
};

/// Which shapes touch, as one number that grows with entities and shapes in this order.
[[nodiscard]] constexpr std::uint64_t number_of_shapes(int a, int b, int shape_a, int shape_b) {
  return static_cast<std::uint64_t>(a) << 48 | static_cast<std::uint64_t>(b) << 32 |
         static_cast<std::uint64_t>(shape_a) << 16 | static_cast<std::uint64_t>(shape_b);
}
[[nodiscard]] constexpr int shape_of_a(const PairContact& c) { return static_cast<int>(c.shapes >> 16 & 0xffff); }
[[nodiscard]] constexpr int shape_of_b(const PairContact& c) { return static_cast<int>(c.shapes & 0xffff); }

/// Steps of a second in which islands of contacts did not settle within their sweeps (island_solver.h). Plain data.
struct UnsettledSteps {
  int steps = 0;         ///< of the second so far
  int unsettled = 0;     ///< of these
  double sweeps = 0;     ///< [1] sum over these: sweeps that the worst island would have taken, over those that it had
  double left = 0;       ///< [m/s] sum over these: what these sweeps would have changed
  double most_left = 0;  ///< [m/s] in one of these, by the island
  int first = -1;        ///< whose first entity has this number in the world (World::index_of)
  int members = 0;       ///< and which has so many
};

/// All contacts between moving entities. One value, in a column of the world (World::common).
struct PairSet {
  std::vector<int> entities;                  ///< by PairContact::a and b: number in the world (World::index_of)
  std::vector<PairContact> points;            ///< sorted by shapes, then by feature
  std::vector<ContactParameters> parameters;  ///< by Contact::surface
  std::vector<PairContact> blocked;           ///< between two that cannot be pushed: no force (kinematic_separation.h)
  std::vector<PairContact> previous;          ///< of the step before; working memory
  std::vector<Interpenetration> interpenetrations;  ///< so far, for warnings
  UnsettledSteps unsettled, most_unsettled;         ///< of the present second, and of the worst one so far; no state
  TestCounts tests;  ///< of this step; no state: they depend on what is remembered of neighbors
};

void append_hash(Hasher& hasher, const PairSet& set);
void state(StateArchive& archive, PairSet& set);

inline constexpr Property<PairSet> pair_contacts{
    {"pair_contacts", "-", "world", "points where moving bodies touch each other", Scope::base}};

}  // namespace murosimf::collision
