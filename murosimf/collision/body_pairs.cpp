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

void state(StateArchive& archive, PairSet& set) {
  archive(set.entities, set.points, set.parameters, set.blocked, set.interpenetrations);
}

}  // namespace murosimf::collision
