#include "murosimf/ros2/bounds_filter.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

#include "murosimf/collision/colliding_shapes.h"
#include "murosimf/geometry/distance.h"
#include "murosimf/geometry/hull.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"

namespace murosimf::ros2 {
namespace {

bool is_number(const Vec3d& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

void check(const Region& region) {
  if (!std::ranges::all_of(region.points, is_number)) throw SetupError("the bounds have numbers that are not finite");
  if (region.type == BoundsType::convex_hull) return;
  if (region.points.size() != 2) throw SetupError("bounds that are a box or a sphere have two points");
}

std::pair<Shape, Vec3d> box_of(const Region& region) {
  const Vec3d &upper = region.points[0], &lower = region.points[1];
  const Vec3d half = 0.5 * (upper - lower);
  if (!(half.x > 0 && half.y > 0 && half.z > 0))
    throw SetupError("the first point of a box is its upper corner, the second one its lower corner");
  return {Box{half}, 0.5 * (upper + lower)};
}

std::pair<Shape, Vec3d> sphere_of(const Region& region) {
  const double radius = region.points[1].x;
  if (!(radius > 0)) throw SetupError("the x of the second point of a sphere is its radius, more than 0");
  return {Sphere{radius}, region.points[0]};
}

std::pair<Shape, Vec3d> hull_of(const Region& region) {
  geometry::Hull made = geometry::make_hull(region.points);
  return {Convex{std::make_shared<const ConvexHull>(std::move(made.hull))}, made.middle};
}

}  // namespace

BoundsFilter::BoundsFilter(const Region& region) {
  MUROSIMF_ASSERT(region.is_known());
  check(region);
  std::tie(shape_, place_.position) = region.type == BoundsType::box      ? box_of(region)
                                      : region.type == BoundsType::sphere ? sphere_of(region)
                                                                          : hull_of(region);
}

bool BoundsFilter::meets(const Entity& entity) const {
  const auto* const positions = entity.find(properties::position);
  const auto* const turns = entity.find(properties::orientation);
  if (!positions || !turns) return false;
  const auto touches = [&](const Shape& shape, const Transformd& at) {
    return geometry::distance(shape, at, shape_, place_).distance <= 0;
  };
  const std::vector<collision::CollidingShape> shapes = collision::colliding_shapes(entity.model());
  if (shapes.empty()) return touches(Sphere{0}, {positions->values[0], {}});
  return std::ranges::any_of(shapes, [&](const collision::CollidingShape& one) {
    const auto i = static_cast<std::size_t>(one.object);
    return touches(one.placed.shape, Transformd{positions->values[i], turns->values[i]} * one.placed.place());
  });
}

}  // namespace murosimf::ros2
