#include "murosimf/collision/interpenetration.h"

#include <algorithm>
#include <limits>
#include <type_traits>

#include "murosimf/collision/body_pairs.h"
#include "murosimf/collision/moving_entity.h"
#include "murosimf/collision/static_compound.h"
#include "murosimf/geometry/ray.h"

namespace murosimf::collision {
namespace {

/// Between each face and the corner that is farthest from it: of a polytope the least distance of parallel planes is taken at a face, or
/// at two edges, where it is not much less.
double thickness_of(const ConvexHull& hull) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < hull.faces.size(); ++i) {
    const Vec3d& on_face = hull.vertices[hull.faces[i].front()];
    double farthest = 0;
    for (const Vec3d& vertex : hull.vertices) farthest = std::max(farthest, dot(hull.normals[i], on_face - vertex));
    least = std::min(least, farthest);
  }
  return least;
}

double smallest(const Vec3d& v) { return std::min({v.x, v.y, v.z}); }

struct Thickness {
  double operator()(const Sphere& s) const { return 2 * s.radius; }
  double operator()(const Box& s) const { return 2 * smallest(s.half_size); }
  double operator()(const Capsule& s) const { return 2 * s.radius; }
  double operator()(const Cylinder& s) const { return 2 * std::min(s.radius, s.half_length); }
  double operator()(const Ellipsoid& s) const { return 2 * smallest(s.semi_axes); }
  double operator()(const Plane&) const { return std::numeric_limits<double>::infinity(); }
  double operator()(const Convex& s) const { return thickness_of(*s.hull); }
};

bool is_known(const PairSet& set, int a, int b) {
  const auto same = [&](const Interpenetration& known) { return is_of(known, a, b); };
  return std::ranges::any_of(set.interpenetrations, same);
}

/// True if the same shapes touched from the other side in the step before.
bool has_crossed(const PairContact& c, const std::vector<PairContact>& previous) {
  const auto before = std::ranges::lower_bound(previous, c.shapes, {}, &PairContact::shapes);
  return before != previous.end() && before->shapes == c.shapes && before->lift == 0 &&
         have_turned(before->normal, c.normal);
}

/// The middle of a body without joints on its way through a step.
struct Way {
  Vec3d from, along;  // [m] world
  double length;      // [m]

  /// Into the shape and out of it again; who begins inside has a contact.
  [[nodiscard]] bool leads_through(const Shape& shape, const Transformd& at) const {
    const double reach = bounding_radius(shape) + length;
    if (dot(at.position - from, at.position - from) > reach * reach) return false;
    const Vec3d direction = (1 / length) * along;
    const auto entry = geometry::meet({from, direction}, shape, at);
    if (!entry || entry->distance == 0 || entry->distance > length) return false;
    const auto exit = geometry::meet({from + along, -direction}, shape, at);
    return exit && exit->distance > 0;
  }
};

bool touch(const PairSet& set, int a, int b) {
  return std::ranges::any_of(set.points, [&](const PairContact& c) { return c.a == a && c.b == b; });
}

/// [m] by which it moves until the next step, seen from something that moves with `other` [m/s].
Way way_of(const MovingEntity& body, const Vec3d& other, double dt) {
  const Vec3d along = dt * (body.v[0] - other);
  return {body.sphere(0).center, along, norm(along)};
}

bool is_fast(const MovingEntity& body, double dt) {
  return !body.apart() && body.compound.shapes().size() == 1 && body.model().joints().empty() &&
         norm(body.v[0]) * dt > body.thickness(0);
}

void note_jump(const MovingEntity& body, int other, int object, double thinner, Duration now, PairSet& set) {
  if (is_known(set, body.number, other)) return;
  set.interpenetrations.push_back(
      {body.number, other, body.compound.shapes()[0].object, object, 0, thinner, true, now});
}

void note_jumps_through(const MovingEntity& body, MovingEntity& other, double dt, Duration now, PairSet& set) {
  for (int i = 0; i < static_cast<int>(other.compound.shapes().size()); ++i) {
    const CollidingShape& shape = other.compound.shapes()[i];
    if (!way_of(body, other.v[shape.object], dt).leads_through(shape.placed.shape, other.pose(i))) continue;
    note_jump(body, other.number, shape.object, std::min(body.thickness(0), other.thickness(i)), now, set);
  }
}

bool touches(const MovingEntity& body, int object) {
  const ContactSet& set = body.contacts;
  return std::ranges::any_of(set.points,
                             [&](const ContactPoint& c) { return set.environment_objects[c.surface] == object; });
}

void note_jumps_through(const MovingEntity& body, const Standing& standing, double dt, Duration now, PairSet& set) {
  const Way way = way_of(body, {}, dt);
  for (int i = 0; i < static_cast<int>(standing.compound.compound().shapes().size()); ++i) {
    const CollidingShape& other = standing.compound.shape(i);
    if (!way.leads_through(other.placed.shape, standing.compound.pose(i)) || touches(body, other.object)) continue;
    note_jump(body, standing.number, other.object, std::min(body.thickness(0), thickness(other.placed.shape)), now,
              set);
  }
}

}  // namespace

static_assert(std::is_trivially_copyable_v<Interpenetration>);

double thickness(const Shape& shape) { return std::visit(Thickness{}, shape); }

Depth depth_of(const ContactPoint& point, double thickness, double dt, bool turned) noexcept {
  const double most = 0.5 * thickness;
  if (point.lift > 0) return norm(point.velocity) * dt > most ? Depth::through : Depth::usual;
  if (turned) return Depth::through;
  return point.depth > most ? Depth::too_deep : Depth::usual;
}

void note_interpenetrations(std::span<const MovingEntity> moving_entities, double dt, Duration now, PairSet& set) {
  for (const PairContact& c : set.points) {
    const double thinner =
        std::min(moving_entities[c.a].thickness(shape_of_a(c)), moving_entities[c.b].thickness(shape_of_b(c)));
    const Depth depth = depth_of(c, thinner, dt, has_crossed(c, set.previous));
    if (depth == Depth::usual || is_known(set, set.entities[c.a], set.entities[c.b])) continue;
    set.interpenetrations.push_back(
        {set.entities[c.a], set.entities[c.b], c.object, c.object_b, c.depth, thinner, depth == Depth::through, now});
  }
}

void note_jumps(std::span<MovingEntity> moving_entities, const Standing& standing, double dt, Duration now,
                PairSet& set) {
  for (int i = 0; i < static_cast<int>(moving_entities.size()); ++i) {
    const MovingEntity& body = moving_entities[i];
    if (!is_fast(body, dt)) continue;
    for (int j = 0; j < static_cast<int>(moving_entities.size()); ++j) {
      MovingEntity& other = moving_entities[j];
      if (i == j || other.apart() || touch(set, std::min(i, j), std::max(i, j))) continue;
      note_jumps_through(body, other, dt, now, set);
    }
    note_jumps_through(body, standing, dt, now, set);
  }
}

}  // namespace murosimf::collision
