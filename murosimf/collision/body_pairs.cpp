#include "murosimf/collision/body_pairs.h"

namespace murosimf::collision {

void append_hash(Hasher& hasher, const PairSet& set) {
  hasher.add(static_cast<std::uint64_t>(set.points.size()));
  for (const PairContact& point : set.points) {
    hasher.add(point.shapes);
    append_hash(hasher, static_cast<const ContactPoint&>(point));
    for (const Vec3d& v :
         {point.point, point.normal, point.force, point.arm_a, point.arm_b, point.velocity_a, point.velocity_b}) {
      append_hash(hasher, v);
    }
    hasher.add(point.normal_damping);
    hasher.add(point.tangent_damping);
  }
}

static void state(StateArchive& archive, PairContact& c) {
  constexpr std::size_t own =
      4 * sizeof(int) + sizeof(c.shapes) + 4 * sizeof(Vec3d);  // three int and what aligns `shapes`
  static_assert(sizeof(PairContact) == sizeof(ContactPoint) + own, "is a new member stored here?");
  state(archive, static_cast<ContactPoint&>(c));
  archive(c.a, c.b, c.object_b, c.shapes, c.arm_a, c.arm_b, c.velocity_a, c.velocity_b);
}

void state(StateArchive& archive, PairSet& set) {
  archive(set.entities, set.points, set.parameters, set.blocked, set.interpenetrations);
}

}  // namespace murosimf::collision
