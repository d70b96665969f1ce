#include "murosimf/collision/ground_points.h"

#include <limits>

#include "murosimf/collision/colliding_shapes.h"
#include "murosimf/geometry/low_points.h"
#include "murosimf/math/assert.h"

namespace murosimf::collision {

std::uint32_t features_of(const Shape& shape) { return geometry::low_point_features(shape); }

GroundShape ground_shape(int object, const PlacedShape& placed, std::uint32_t first_feature) {
  const double reach = bounding_radius(placed.shape);
  MUROSIMF_ASSERT(object >= 0 && reach >= 0);
  return {object, placed, reach, norm(placed.position) + reach, first_feature};
}

namespace {

std::vector<GroundShape> make_ground_shapes(const Model& model) {
  std::vector<GroundShape> result;
  std::uint32_t feature = 0;
  for (const CollidingShape& shape : colliding_shapes(model)) {
    result.push_back(ground_shape(shape.object, shape.placed, feature));
    feature += features_of(shape.placed.shape);
  }
  return result;
}

}  // namespace

const std::vector<GroundShape>& ground_shapes(const Model& model) {
  return *model.derived().get<std::vector<GroundShape>>("ground_shapes", [&] { return make_ground_shapes(model); });
}

bool find_ground_contacts(const GroundShape& shape, const Vec3d& r, const Mat3d& R, const GroundPlane& plane,
                          std::vector<ContactPoint>& found) {
  if (is_out_of_reach(shape, r, plane)) return false;  // about the object's origin: needs no attitude
  const Vec3d center = r + R * shape.placed.position;
  if (dot(plane.normal, center) - plane.height > shape.reach) return false;
  const geometry::LowPoints points{center, R * shape.placed.orientation, plane.normal, plane.height};
  const auto emit = [&](std::uint32_t feature, const Vec3d& point, double radius) {
    const double depth = plane.height - dot(plane.normal, point);
    if (depth <= 0) return;  // touching without depth has no force
    ContactPoint& c = found.emplace_back();
    c.object = shape.object;
    c.feature = shape.first_feature + feature;
    c.point = point;
    c.normal = plane.normal;
    c.depth = depth;
    c.radius = radius;
  };
  std::visit([&](const auto& s) { points(s, emit); }, shape.placed.shape);
  return true;
}

double lowest_point(const GroundShape& shape, const Vec3d& r, const Mat3d& R, const GroundPlane& plane) {
  double lowest = std::numeric_limits<double>::infinity();
  const geometry::LowPoints points{r + R * shape.placed.position, R * shape.placed.orientation, plane.normal};
  const auto emit = [&](std::uint32_t, const Vec3d& point, double) {
    lowest = std::min(lowest, dot(plane.normal, point) - plane.height);
  };
  std::visit([&](const auto& s) { points(s, emit); }, shape.placed.shape);
  return lowest;
}

}  // namespace murosimf::collision
