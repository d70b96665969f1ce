#include "murosimf/model/shape.h"

#include <algorithm>
#include <array>
#include <limits>

namespace murosimf {
namespace {

struct BoundingRadius {
  double operator()(const Sphere& s) const { return s.radius; }
  double operator()(const Box& s) const { return norm(s.half_size); }
  double operator()(const Capsule& s) const { return s.half_length + s.radius; }
  double operator()(const Cylinder& s) const { return std::hypot(s.half_length, s.radius); }
  double operator()(const Ellipsoid& s) const { return std::max({s.semi_axes.x, s.semi_axes.y, s.semi_axes.z}); }
  double operator()(const Plane&) const { return std::numeric_limits<double>::infinity(); }
  double operator()(const Convex& s) const {
    double square = 0;
    for (const Vec3d& vertex : s.hull->vertices) square = std::max(square, dot(vertex, vertex));
    return std::sqrt(square);
  }
};

}  // namespace

const char* shape_name(const Shape& shape) {
  constexpr std::array names{"sphere", "box", "capsule", "cylinder", "ellipsoid", "plane", "mesh"};
  return names[shape.index()];
}

double bounding_radius(const Shape& shape) { return std::visit(BoundingRadius{}, shape); }

}  // namespace murosimf
