#include "murosimf/collision/contact.h"

#include <algorithm>
#include <cstdint>

#include "murosimf/math/assert.h"

namespace murosimf::collision {

void append_hash(Hasher& hasher, const ContactPoint& point) {
  hasher.add(point.feature);
  hasher.add(std::uint64_t{static_cast<std::uint8_t>(point.state)});
  hasher.add(point.last_normal_force);
  append_hash(hasher, point.stretch);
  append_hash(hasher, point.slip_direction);
  if (point.lift > 0) hasher.add(point.lift);
  if (point.bounce >= 0) hasher.add(point.bounce);
}

SymMat3d angular_damping_matrix(const ContactPoint& c) noexcept {
  const SymMat3d isotropic = diagonal(c.angular_damping);
  return c.spin_damping == c.angular_damping ? isotropic
                                             : isotropic + (c.spin_damping - c.angular_damping) * outer(c.normal);
}

void recall(const ContactPoint& old, ContactPoint& point) noexcept {
  point.stretch = old.stretch;
  point.state = old.state;
  point.last_normal_force = old.last_normal_force;
  point.slip_direction = old.slip_direction;
  point.lift = old.lift;
  point.bounce = old.bounce;
}

void append_hash(Hasher& hasher, const ContactSet& set) {
  hasher.add(static_cast<std::uint64_t>(set.points.size()));
  for (const ContactPoint& point : set.points) append_hash(hasher, point);
}

namespace {

/// A point without bytes between its members: one copy instead of twenty small ones.
struct StoredPoint {
  std::uint64_t feature = 0;
  std::int32_t object = 0;
  std::uint32_t surface = 0;
  std::uint64_t state = 0;
  Vec3d point, normal;
  double depth = 0, radius = 0;
  Vec3d velocity, angular_velocity, stretch, force, moment;
  double normal_damping = 0, tangent_damping = 0, angular_damping = 0, spin_damping = 0, last_normal_force = 0;
  Vec3d slip_direction;
  double lift = 0, bounce = 0;
};

StoredPoint stored(const ContactPoint& c) {
  return {c.feature,         c.object,
          c.surface,         static_cast<std::uint64_t>(c.state),
          c.point,           c.normal,
          c.depth,           c.radius,
          c.velocity,        c.angular_velocity,
          c.stretch,         c.force,
          c.moment,          c.normal_damping,
          c.tangent_damping, c.angular_damping,
          c.spin_damping,    c.last_normal_force,
          c.slip_direction,  c.lift,
          c.bounce};
}

ContactPoint point_of(const StoredPoint& s) {
  ContactPoint c;
  static_cast<Contact&>(c) = {s.object, s.feature, s.surface, s.point, s.normal, s.depth, s.radius};
  c.velocity = s.velocity;
  c.angular_velocity = s.angular_velocity;
  c.stretch = s.stretch;
  c.state = static_cast<ContactState>(s.state);
  c.force = s.force;
  c.moment = s.moment;
  c.normal_damping = s.normal_damping;
  c.tangent_damping = s.tangent_damping;
  c.angular_damping = s.angular_damping;
  c.spin_damping = s.spin_damping;
  c.last_normal_force = s.last_normal_force;
  c.slip_direction = s.slip_direction;
  c.lift = s.lift;
  c.bounce = s.bounce;
  return c;
}

}  // namespace

void state(StateArchive& archive, ContactPoint& c) {
  constexpr std::size_t own = sizeof(double) + 6 * sizeof(Vec3d) + 7 * sizeof(double);
  static_assert(sizeof(ContactPoint) == sizeof(Contact) + own, "is a new member stored here?");
  StoredPoint point;
  if (!archive.loads()) point = stored(c);
  archive(point);
  if (archive.loads()) c = point_of(point);
}

void state(StateArchive& archive, ContactSet& set) {
  archive(set.points, set.environment, set.environment_objects, set.stiff, set.interpenetration, set.solved,
          set.island_stands, set.rest_force, set.rest_damping, set.loaded);
}

namespace {

/// b_n n n^T + b_t (1 - n n^T - d d^T).
SymMat3d damping_matrix(const ContactPoint& c) {
  const SymMat3d isotropic = diagonal(c.tangent_damping) + (c.normal_damping - c.tangent_damping) * outer(c.normal);
  return c.state == ContactState::slip ? isotropic - c.tangent_damping * outer(c.slip_direction) : isotropic;
}

}  // namespace

void write_loads(const ContactSet& set, std::span<const Vec3d> r, std::span<Wrenchd> external_force,
                 std::span<Sym6d> external_damping) noexcept {
  MUROSIMF_ASSERT(external_force.size() == r.size() && external_damping.size() == r.size());
  for (const int object : set.loaded) {
    external_force[object] = set.rest_force[object];
    external_damping[object] = Sym6d{};
  }
  for (const auto& [object, damping] : set.rest_damping) {
    if (std::find(set.loaded.begin(), set.loaded.end(), object) != set.loaded.end())
      external_damping[object] += damping;
  }
  for (const ContactPoint& c : set.points) {
    const Vec3d arm = c.point - r[c.object];
    external_force[c.object] += Wrenchd{c.moment + cross(arm, c.force), c.force};
    if (c.normal_damping == 0 && c.tangent_damping == 0 && c.angular_damping == 0 && c.spin_damping == 0) continue;
    Sym6d damping = at_point(damping_matrix(c), arm);
    damping.J += angular_damping_matrix(c);
    external_damping[c.object] += damping;
  }
}

void write_final_forces(const ContactSet& set, std::span<const Vec3d> r, std::span<Wrenchd> external_force) noexcept {
  MUROSIMF_ASSERT(external_force.size() == r.size());
  for (const int object : set.loaded) external_force[object] = set.rest_force[object];
  for (const ContactPoint& c : set.points) {
    external_force[c.object] += Wrenchd{c.moment + cross(c.point - r[c.object], c.force), c.force};
  }
}

}  // namespace murosimf::collision
