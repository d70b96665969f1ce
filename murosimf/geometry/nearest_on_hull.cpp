#include <algorithm>
#include <limits>

#include "murosimf/geometry/nearest.h"

namespace murosimf::geometry {
namespace {

Vec3d nearest_on_edge(const Vec3d& a, const Vec3d& b, const Vec3d& p) {
  const Vec3d way = b - a;
  const double square = dot(way, way);
  return square > 0 ? a + std::clamp(dot(p - a, way) / square, 0.0, 1.0) * way : a;
}

/// Nearest point of face `f` to p, which is `height` above its plane.
Vec3d nearest_on_face(const ConvexHull& hull, std::size_t f, const Vec3d& p, double height) {
  const auto& face = hull.faces[f];
  const Vec3d foot = p - height * hull.normals[f];
  bool inside = true;
  Vec3d best;
  double best_square = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < face.size(); ++k) {
    const Vec3d& a = hull.vertices[face[k]];
    const Vec3d& b = hull.vertices[face[(k + 1) % face.size()]];
    if (dot(cross(hull.normals[f], b - a), foot - a) >= 0) continue;
    inside = false;
    const Vec3d point = nearest_on_edge(a, b, foot);
    const Vec3d way = foot - point;
    if (dot(way, way) < best_square) {
      best_square = dot(way, way);
      best = point;
    }
  }
  return inside ? foot : best;
}

}  // namespace

Nearest nearest_on_hull(const ConvexHull& hull, const Vec3d& p) {
  Nearest inside;
  inside.distance = -std::numeric_limits<double>::infinity();
  Nearest outside;
  outside.distance = std::numeric_limits<double>::infinity();
  for (std::size_t f = 0; f < hull.faces.size(); ++f) {
    const double height = dot(hull.normals[f], p - hull.vertices[hull.faces[f][0]]);
    if (height > inside.distance) inside = {p - height * hull.normals[f], hull.normals[f], height};
    if (height <= 0 || height >= outside.distance) continue;
    const Vec3d point = nearest_on_face(hull, f, p, height);
    const double distance = norm(p - point);
    if (distance < outside.distance) outside = {point, hull.normals[f], distance};
  }
  if (inside.distance <= 0) return inside;
  // a hair outside, the face's normal is better than the difference of two points
  if (outside.distance > (1 + 1e-12) * inside.distance) outside.normal = (1 / outside.distance) * (p - outside.point);
  return outside;
}

}  // namespace murosimf::geometry
