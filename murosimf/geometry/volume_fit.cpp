#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "murosimf/geometry/capsule_along.h"
#include "murosimf/math/assert.h"

namespace murosimf::geometry {
namespace {

/// How far a shape reaches along the unit vector d, from its origin.
struct Extent {
  Vec3d d;

  double operator()(const Sphere& s) const { return s.radius; }
  double operator()(const Box& s) const { return dot(componentwise_abs(d), s.half_size); }
  double operator()(const Capsule& s) const { return abs(d.z) * s.half_length + s.radius; }
  double operator()(const Cylinder& s) const { return abs(d.z) * s.half_length + std::hypot(d.x, d.y) * s.radius; }
  double operator()(const Ellipsoid& s) const {
    return norm(Vec3d{d.x * s.semi_axes.x, d.y * s.semi_axes.y, d.z * s.semi_axes.z});
  }
  double operator()(const Plane&) const { return std::numeric_limits<double>::infinity(); }
  double operator()(const Convex& s) const {
    double farthest = -std::numeric_limits<double>::infinity();
    for (const Vec3d& vertex : s.hull->vertices) farthest = std::max(farthest, dot(vertex, d));
    return farthest;
  }
};

/// Box about a shape along `axes`, which are given in the shape's frame; so is the center, along the axes.
Aabb box_along(const Shape& shape, const Mat3d& axes) {
  const auto reach = [&](const Vec3d& d) { return std::visit(Extent{d}, shape); };
  const Vec3d high{reach(axes.x), reach(axes.y), reach(axes.z)};
  const Vec3d low{-reach(-axes.x), -reach(-axes.y), -reach(-axes.z)};
  return {0.5 * (low + high), 0.5 * (high - low)};
}

using Points = std::vector<Vec3d>;

std::pair<Vec3d, double> farthest_from(const Vec3d& center, const Points& points) {
  std::pair<Vec3d, double> result{center, 0};
  for (const Vec3d& p : points) {
    const double distance = norm(p - center);
    if (distance > result.second) result = {p, distance};
  }
  return result;
}

/// About one percent above the smallest sphere: the center moves towards the farthest point, ever less.
/// Source: Badoiu and Clarkson, "Smaller core-sets for balls", SODA 2003.
BoundingSphere sphere_about(const Points& points) {
  BoundingSphere best{{}, farthest_from({}, points).second};
  Vec3d center;
  for (int i = 1; i <= 100; ++i) {
    center += (1.0 / (i + 1)) * (farthest_from(center, points).first - center);
    const double radius = farthest_from(center, points).second;
    if (radius < best.radius) best = {center, radius};
  }
  return best;
}

double volume_of(const BoundingCapsule& v) {
  return std::numbers::pi * v.radius * v.radius * (2 * norm(v.half_axis) + 4.0 / 3.0 * v.radius);
}

const BoundingCapsule& smaller(const BoundingCapsule& a, const BoundingCapsule& b) {
  return volume_of(b) < volume_of(a) ? b : a;
}

BoundingCapsule capsule_about(const Points& points, const Vec3d& middle) {
  const BoundingSphere sphere = sphere_about(points);
  BoundingCapsule best{sphere.center, {}, sphere.radius};
  std::vector<BoundingSphere> spheres;
  for (const Vec3d& p : points) spheres.push_back({p, 0});
  const Mat3d axes;
  for (const Vec3d& axis : {axes.x, axes.y, axes.z}) best = smaller(capsule_along(axis, middle, spheres), best);
  return best;
}

/// In the shape's frame.
struct CapsuleFit {
  BoundingCapsule operator()(const Sphere& s) const { return {{}, {}, s.radius}; }
  BoundingCapsule operator()(const Capsule& s) const { return {{}, {0, 0, s.half_length}, s.radius}; }
  BoundingCapsule operator()(const Cylinder& s) const {
    return smaller({{}, {0, 0, s.half_length}, s.radius}, {{}, {}, std::hypot(s.half_length, s.radius)});
  }
  BoundingCapsule operator()(const Ellipsoid& s) const {
    // as wide as the middle semi-axis: its ends then are less curved than the ellipsoid's
    const auto [x, y, z] = s.semi_axes;
    if (x >= y && x >= z) return {{}, {x - std::max(y, z), 0, 0}, std::max(y, z)};
    if (y >= z) return {{}, {0, y - std::max(x, z), 0}, std::max(x, z)};
    return {{}, {0, 0, z - std::max(x, y)}, std::max(x, y)};
  }
  BoundingCapsule operator()(const Box& s) const {
    Points corners;
    for (int i = 0; i < 8; ++i) {
      corners.push_back({i & 1 ? s.half_size.x : -s.half_size.x, i & 2 ? s.half_size.y : -s.half_size.y,
                         i & 4 ? s.half_size.z : -s.half_size.z});
    }
    return capsule_about(corners, {});
  }
  BoundingCapsule operator()(const Convex& s) const { return capsule_about(s.hull->vertices, box_along(s, {}).center); }
  BoundingCapsule operator()(const Plane&) const { return {{}, {}, std::numeric_limits<double>::infinity()}; }
};

}  // namespace

template <>
BoundingSphere fit<BoundingSphere>(const Shape& shape, const Transformd& at) {
  MUROSIMF_ASSERT(!std::holds_alternative<Plane>(shape));
  const auto* convex = std::get_if<Convex>(&shape);
  const BoundingSphere own = convex ? sphere_about(convex->hull->vertices) : BoundingSphere{{}, bounding_radius(shape)};
  return moved(own, at.position, at.orientation);
}

template <>
Aabb fit<Aabb>(const Shape& shape, const Transformd& at) {
  MUROSIMF_ASSERT(!std::holds_alternative<Plane>(shape));
  const Aabb box = box_along(shape, transpose(at.orientation));
  return {at.position + box.center, box.half};
}

template <>
Obb fit<Obb>(const Shape& shape, const Transformd& at) {
  MUROSIMF_ASSERT(!std::holds_alternative<Plane>(shape));
  const Aabb box = box_along(shape, {});
  return moved(Obb{box.center, {}, box.half}, at.position, at.orientation);
}

template <>
BoundingCapsule fit<BoundingCapsule>(const Shape& shape, const Transformd& at) {
  MUROSIMF_ASSERT(!std::holds_alternative<Plane>(shape));
  return moved(std::visit(CapsuleFit{}, shape), at.position, at.orientation);
}

}  // namespace murosimf::geometry
