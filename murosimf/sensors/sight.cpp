#include "murosimf/sensors/sight.h"

#include <cmath>

#include "murosimf/geometry/support.h"

namespace murosimf::sensors {
namespace {

constexpr int outline_points = 8;

bool is_free(collision::QueryScene& scene, const Vec3d& eye, const Entity* without, const Seen& body,
             const Vec3d& point) noexcept {
  // the body itself may be hit first: its own shapes do not hide it
  const Vec3d way = point - eye;
  const double distance = norm(way);
  if (distance == 0) return true;
  const auto hit = scene.cast({eye, (1 / distance) * way}, {.range = distance, .without = without});
  return !hit || hit->body.entity == body.entity;
}

/// A point near the end of the body in the direction `across` [1]; at 0.8 of the way, so that rounding of the outline does not hide it.
Vec3d outline_point(const Seen& body, const Vec3d& across) noexcept {
  Vec3d best;
  double farthest = -std::numeric_limits<double>::infinity();
  for (const collision::CollidingShape& shape : body.shapes) {
    const Transformd at = Transformd{body.r[shape.object], body.R[shape.object]} * shape.placed.place();
    const Vec3d arm = at.orientation * geometry::support(shape.placed.shape, transposed_times(at.orientation, across));
    const double reach = dot(at.position + arm, across);
    // the shape that reaches farthest forms the outline
    if (reach <= farthest) continue;
    farthest = reach;
    best = at.position + 0.8 * arm;
  }
  return best;
}

/// Calls see(whether it is free, number of points) for each of the points until it returns false.
template <class See>
void for_points(collision::QueryScene& scene, const Vec3d& eye, const Entity* without, const Seen& body,
                const See& see) noexcept {
  const Vec3d way = body.r[0] - eye;
  const Vec3d beside = abs(way.z) < 0.9 * norm(way) ? cross(way, Vec3d{0, 0, 1}) : cross(way, Vec3d{1, 0, 0});
  const double length = norm(beside);
  // a body without shapes, or straight above, is tested by its origin only
  const int points = body.shapes.empty() || length == 0 ? 1 : 1 + outline_points;
  if (!see(is_free(scene, eye, without, body, body.r[0]), points) || points == 1) return;
  const Vec3d u = (1 / length) * beside, v = (1 / norm(way)) * cross(u, way);
  for (int i = 0; i < outline_points; ++i) {
    const double angle = 2 * pi * i / outline_points;
    const Vec3d point = outline_point(body, std::cos(angle) * u + std::sin(angle) * v);
    if (!see(is_free(scene, eye, without, body, point), points)) return;
  }
}

}  // namespace

double share_in_sight(collision::QueryScene& scene, const Vec3d& eye, const Entity* without,
                      const Seen& body) noexcept {
  int free = 0;
  double share = 0;
  for_points(scene, eye, without, body, [&](bool is_free, double points) {
    free += is_free ? 1 : 0;
    share = free / points;
    return true;
  });
  return share;
}

bool is_in_sight(collision::QueryScene& scene, const Vec3d& eye, const Entity* without, const Seen& body,
                 double share) noexcept {
  int free = 0, hidden = 0;
  bool seen = false;
  for_points(scene, eye, without, body, [&](bool is_free, double points) {
    ++(is_free ? free : hidden);
    seen = free > 0 && free / points >= share;
    // ends as soon as the answer is certain: rays are expensive
    return !seen && (points - hidden) / points >= share;
  });
  return seen;
}

}  // namespace murosimf::sensors
