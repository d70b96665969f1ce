#include "murosimf/geometry/support.h"

#include <cmath>

namespace murosimf::geometry {
namespace {

/// The core of the shape: without the margin of spheres and capsules.
struct CoreSupport {
  Vec3d d;

  Vec3d operator()(const Sphere&) const { return {}; }
  Vec3d operator()(const Box& s) const {
    return {std::copysign(s.half_size.x, d.x), std::copysign(s.half_size.y, d.y), std::copysign(s.half_size.z, d.z)};
  }
  Vec3d operator()(const Capsule& s) const { return {0, 0, std::copysign(s.half_length, d.z)}; }
  Vec3d operator()(const Cylinder& s) const {
    const double across = std::hypot(d.x, d.y);
    const double scale = across > 0 ? s.radius / across : 0;
    return {scale * d.x, scale * d.y, std::copysign(s.half_length, d.z)};
  }
  Vec3d operator()(const Ellipsoid& s) const {
    const Vec3d a{s.semi_axes.x * d.x, s.semi_axes.y * d.y, s.semi_axes.z * d.z};
    const double length = norm(a);
    if (!(length > 0)) return {};
    return {s.semi_axes.x * a.x / length, s.semi_axes.y * a.y / length, s.semi_axes.z * a.z / length};
  }
  Vec3d operator()(const Plane&) const { return {}; }
  Vec3d operator()(const Convex& s) const {
    const auto& vertices = s.hull->vertices;
    std::size_t best = 0;
    double highest = dot(d, vertices[0]);
    for (std::size_t i = 1; i < vertices.size(); ++i) {
      const double height = dot(d, vertices[i]);
      if (height > highest) {
        highest = height;
        best = i;
      }
    }
    return vertices[best];
  }
};

double margin_of(const Shape& shape) {
  if (const auto* sphere = std::get_if<Sphere>(&shape)) return sphere->radius;
  if (const auto* capsule = std::get_if<Capsule>(&shape)) return capsule->radius;
  return 0;
}

}  // namespace

Vec3d support(const Shape& shape, const Vec3d& d) {
  const Vec3d core = std::visit(CoreSupport{d}, shape);
  const double margin = margin_of(shape);
  return margin > 0 ? core + (margin / norm(d)) * d : core;
}

Body::Body(const Shape& shape, const Transformd& at) : shape_(&shape), at_(&at), margin_(margin_of(shape)) {}

Vec3d Body::core_support(const Vec3d& d) const {
  return at_->position + at_->orientation * std::visit(CoreSupport{transposed_times(at_->orientation, d)}, *shape_);
}

}  // namespace murosimf::geometry
