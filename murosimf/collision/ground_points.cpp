#include "murosimf/collision/ground_points.h"

#include <algorithm>
#include <limits>

#include "murosimf/collision/colliding_shapes.h"

namespace murosimf::collision {
namespace {

/// Calls `emit(feature, point, radius)` for each point of the shape that may be the lowest; world frame. `n`: the
/// plane's normal. The lowest point of the shape is always among them.
struct LowPoints {
  Vec3d center;  // of the shape, world frame
  Mat3d R;       // shape axes to world axes
  Vec3d n;

  template <class Emit>
  void operator()(const Sphere& s, const Emit& emit) const {
    emit(0u, center - s.radius * n, s.radius);
  }
  template <class Emit>
  void operator()(const Box& s, const Emit& emit) const {
    for (std::uint32_t i = 0; i < 8; ++i) {
      const Vec3d corner{i & 1 ? s.half_size.x : -s.half_size.x, i & 2 ? s.half_size.y : -s.half_size.y,
                         i & 4 ? s.half_size.z : -s.half_size.z};
      emit(i, center + R * corner, 0.0);
    }
  }
  template <class Emit>
  void operator()(const Capsule& s, const Emit& emit) const {
    emit(0u, center - s.half_length * R.z - s.radius * n, s.radius);
    emit(1u, center + s.half_length * R.z - s.radius * n, s.radius);
  }
  template <class Emit>
  void operator()(const Cylinder& s, const Emit& emit) const {
    // on each cap: the lowest rim point, the opposite one, and the two between
    const Vec3d down = tangential(-n, R.z);
    const double size = norm(down);
    const Vec3d first = size > 1e-9 ? (1.0 / size) * down : R.x;
    const Vec3d second = cross(R.z, first);
    const double arm = std::abs(dot(R.z, n)) < 0.5 ? s.radius : 0.0;  // lying it rolls, standing it does not
    for (std::uint32_t cap = 0; cap < 2; ++cap) {
      const Vec3d middle = center + (cap == 0 ? -s.half_length : s.half_length) * R.z;
      emit(4 * cap + 0, middle + s.radius * first, arm);
      emit(4 * cap + 1, middle + s.radius * second, arm);
      emit(4 * cap + 2, middle - s.radius * second, arm);
      emit(4 * cap + 3, middle - s.radius * first, arm);
    }
  }
  template <class Emit>
  void operator()(const Ellipsoid& s, const Emit& emit) const {
    // support point: semi-axes squared times the direction, divided by its scaled length
    const Vec3d d = transposed_times(R, -n);
    const Vec3d a{s.semi_axes.x * d.x, s.semi_axes.y * d.y, s.semi_axes.z * d.z};
    const Vec3d b{s.semi_axes.x * a.x, s.semi_axes.y * a.y, s.semi_axes.z * a.z};
    emit(0u, center + R * ((1.0 / norm(a)) * b), std::min({s.semi_axes.x, s.semi_axes.y, s.semi_axes.z}));
  }
  template <class Emit>
  void operator()(const Plane&, const Emit&) const {}
  template <class Emit>
  void operator()(const Convex&, const Emit&) const {}
};

}  // namespace

GroundShape ground_shape(int object, const PlacedShape& placed, std::uint32_t first_feature) {
  const double reach = bounding_radius(placed.shape);
  return {object, placed, reach, norm(placed.position) + reach, first_feature};
}

std::vector<GroundShape> ground_shapes(const Model& model) {
  std::vector<GroundShape> result;
  std::uint32_t feature = 0;
  for (const CollidingShape& shape : colliding_shapes(model)) {
    result.push_back(ground_shape(shape.object, shape.placed, feature));
    feature += features_per_shape;
  }
  return result;
}

void find_ground_contacts(const GroundShape& shape, const Vec3d& r, const Mat3d& R, const GroundPlane& plane,
                          std::vector<ContactPoint>& found) {
  if (dot(plane.normal, r) - plane.height > shape.object_reach) return;
  const Vec3d center = r + R * shape.placed.position;
  if (dot(plane.normal, center) - plane.height > shape.reach) return;
  const LowPoints points{center, R * shape.placed.orientation, plane.normal};
  const auto emit = [&](std::uint32_t feature, const Vec3d& point, double radius) {
    const double depth = plane.height - dot(plane.normal, point);
    if (depth <= 0) return;
    ContactPoint& c = found.emplace_back();
    c.object = shape.object;
    c.feature = shape.first_feature + feature;
    c.point = point;
    c.normal = plane.normal;
    c.depth = depth;
    c.radius = radius;
  };
  std::visit([&](const auto& s) { points(s, emit); }, shape.placed.shape);
}

double lowest_point(const GroundShape& shape, const Vec3d& r, const Mat3d& R, const GroundPlane& plane) {
  double lowest = std::numeric_limits<double>::infinity();
  const LowPoints points{r + R * shape.placed.position, R * shape.placed.orientation, plane.normal};
  const auto emit = [&](std::uint32_t, const Vec3d& point, double) {
    lowest = std::min(lowest, dot(plane.normal, point) - plane.height);
  };
  std::visit([&](const auto& s) { points(s, emit); }, shape.placed.shape);
  return lowest;
}

}  // namespace murosimf::collision
