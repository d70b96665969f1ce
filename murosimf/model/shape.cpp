#include "murosimf/model/shape.h"

#include <algorithm>
#include <array>
#include <limits>

#include "murosimf/math/assert.h"

namespace murosimf {
namespace {

/// Radius about the shape's origin.
struct BoundingRadius {
  double operator()(const Sphere& s) const { return s.radius; }
  double operator()(const Box& s) const { return norm(s.half_size); }
  double operator()(const Capsule& s) const { return s.half_length + s.radius; }
  double operator()(const Cylinder& s) const { return std::hypot(s.half_length, s.radius); }
  double operator()(const Ellipsoid& s) const { return std::max({s.semi_axes.x, s.semi_axes.y, s.semi_axes.z}); }
  double operator()(const Plane&) const { return std::numeric_limits<double>::infinity(); }
  double operator()(const Convex& s) const {
    MUROSIMF_ASSERT(s.hull);
    double square = 0;
    for (const Vec3d& vertex : s.hull->vertices) square = std::max(square, dot(vertex, vertex));
    return std::sqrt(square);
  }
};

}  // namespace

const char* shape_name(const Shape& shape) {
  constexpr std::array names{"sphere", "box", "capsule", "cylinder", "ellipsoid", "plane", "mesh"};
  MUROSIMF_ASSERT(shape.index() < names.size());
  return names[shape.index()];
}

double bounding_radius(const Shape& shape) { return std::visit(BoundingRadius{}, shape); }

}  // namespace murosimf
