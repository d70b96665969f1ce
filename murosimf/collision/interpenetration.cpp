#include "murosimf/collision/interpenetration.h"

#include <algorithm>
#include <limits>
#include <type_traits>

#include "murosimf/collision/body_pairs.h"
#include "murosimf/collision/contact_laws/bounce.h"
#include "murosimf/collision/moving_entity.h"
#include "murosimf/math/assert.h"
#include "murosimf/world/state_archive.h"

namespace murosimf::collision {
namespace {

/// Between each face and the corner that is farthest from it: of a polytope the least distance of parallel planes is taken at a face, or
/// at two edges, where it is not much less.
double thickness_of(const ConvexHull& hull) {
  MUROSIMF_ASSERT(hull.normals.size() == hull.faces.size());
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

/// True if the same shapes touched from the other side in the preceding step.
bool has_crossed(const PairContact& c, const std::vector<PairContact>& previous) {
  const auto before = std::ranges::lower_bound(previous, c.shapes, {}, &PairContact::shapes);
  return before != previous.end() && before->shapes == c.shapes && before->lift == 0 &&
         have_turned(before->normal, c.normal);
}

}  // namespace

void state(StateArchive& archive, Interpenetration& one) {
  auto& [a, b, object, object_b, depth, thickness, crossed, time] = one;
  archive(a, b, object, object_b, depth, thickness, crossed, time);
}

static_assert(std::is_trivially_copyable_v<Interpenetration>);

double thickness(const Shape& shape) { return std::visit(Thickness{}, shape); }

Depth depth_of(const ContactPoint& point, double thickness, double dt, bool turned) noexcept {
  MUROSIMF_ASSERT(dt > 0 && thickness >= 0);
  const double most = 0.5 * thickness;
  if (point.lift > 0) return norm(point.velocity) * dt > most ? Depth::through : Depth::usual;
  if (turned) return Depth::through;
  if (is_bouncing(point)) return Depth::usual;  // it leaves in the next steps
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

}  // namespace murosimf::collision
