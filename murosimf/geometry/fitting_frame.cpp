#include "murosimf/geometry/fitting_frame.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

#include "murosimf/geometry/mesh_mass.h"

namespace murosimf::geometry {
namespace {

constexpr double alike = 1e-4;         // [1] second moments that differ by less leave their axes free
constexpr double clearly_less = 1e-9;  // [1] rounding must not choose between frames

struct Principal {
  Mat3d axes;
  Vec3d moments;  ///< [m^2] rising
};

Principal principal_of(const SymMat3d& m) {
  Eigen::Matrix3d matrix;
  matrix << m.xx, m.xy, m.xz, m.xy, m.yy, m.yz, m.xz, m.yz, m.zz;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matrix);
  const auto axis = [&](int i) {
    const Eigen::Vector3d v = solver.eigenvectors().col(i);
    return Vec3d{v[0], v[1], v[2]};
  };
  const Vec3d x = axis(0), y = axis(1);
  const Eigen::Vector3d values = solver.eigenvalues();
  return {{x, y, cross(x, y)}, {values[0], values[1], values[2]}};
}

/// Area of the rectangle around the hull, seen along the z axis of the frame.
double area_in(const ConvexHull& hull, const Mat3d& frame) {
  const auto [low, high] = bounds_in(hull, frame);
  return (high.x - low.x) * (high.y - low.y);
}

double volume_in(const ConvexHull& hull, const Mat3d& frame) {
  const auto [low, high] = bounds_in(hull, frame);
  return (high.x - low.x) * (high.y - low.y) * (high.z - low.z);
}

/// The frame with the given z axis whose other axes frame the hull in the smallest rectangle: one side of it lies on an
/// edge of the outline (Freeman and Shapira, "Determining the minimum-area encasing rectangle for an arbitrary closed
/// curve", CACM 18 (1975)), so all edges of the hull are tried.
Mat3d frame_about(const ConvexHull& hull, const Vec3d& z) {
  const Vec3d some = std::fabs(z.x) < 0.6 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
  const Vec3d start = cross(z, some);
  const Vec3d first = (1 / norm(start)) * start;
  Mat3d best{first, cross(z, first), z};
  double least = area_in(hull, best);
  for (std::size_t i = 0; i + 1 < hull.first_neighbor.size(); ++i) {
    for (auto k = hull.first_neighbor[i]; k < hull.first_neighbor[i + 1]; ++k) {
      const Vec3d edge = hull.vertices[hull.neighbors[k]] - hull.vertices[i];
      const Vec3d flat = edge - dot(edge, z) * z;
      const double length = norm(flat);
      if (hull.neighbors[k] < i || length < 1e-6 * norm(edge)) continue;
      const Vec3d x = (1 / length) * flat;
      const Mat3d frame{x, cross(z, x), z};
      const double area = area_in(hull, frame);
      if (area >= (1 - clearly_less) * least) continue;
      least = area;
      best = frame;
    }
  }
  return best;
}

Vec3d normal_of_largest_face(const ConvexHull& hull) {
  double largest = 0;
  Vec3d normal{0, 0, 1};
  for (std::size_t i = 0; i < hull.faces.size(); ++i) {
    const auto& face = hull.faces[i];
    double area = 0;
    for (std::size_t k = 2; k < face.size(); ++k) {
      const Vec3d a = hull.vertices[face[k - 1]] - hull.vertices[face[0]];
      const Vec3d b = hull.vertices[face[k]] - hull.vertices[face[0]];
      area += 0.5 * norm(cross(a, b));
    }
    if (area <= (1 + clearly_less) * largest) continue;
    largest = area;
    normal = hull.normals[i];
  }
  return normal;
}

/// With two moments alike, the axis of the third one is sure and the others are free.
Mat3d settled(const ConvexHull& hull, const Principal& principal) {
  const auto& [axes, m] = principal;
  if (m.y - m.x < alike * m.y) return frame_about(hull, axes.z);
  if (m.z - m.y < alike * m.z) return frame_about(hull, axes.x);
  return axes;
}

Mat3d tightest_of(const ConvexHull& hull, const Principal& principal) {
  Mat3d best = settled(hull, principal);
  double least = volume_in(hull, best);
  for (const Mat3d& frame : {Mat3d{}, frame_about(hull, normal_of_largest_face(hull))}) {
    const double volume = volume_in(hull, frame);
    if (volume >= (1 - clearly_less) * least) continue;
    least = volume;
    best = frame;
  }
  return best;
}

}  // namespace

Bounds bounds_in(const ConvexHull& hull, const Mat3d& frame) {
  const Vec3d first = transposed_times(frame, hull.vertices.at(0));
  Bounds bounds{first, first};
  for (const Vec3d& vertex : hull.vertices) {
    const Vec3d p = transposed_times(frame, vertex);
    bounds.low = {std::min(bounds.low.x, p.x), std::min(bounds.low.y, p.y), std::min(bounds.low.z, p.z)};
    bounds.high = {std::max(bounds.high.x, p.x), std::max(bounds.high.y, p.y), std::max(bounds.high.z, p.z)};
  }
  return bounds;
}

SolidShape solid_shape(const ConvexHull& hull) {
  const SolidMass solid = solid_mass(hull);
  const SymMat3d I = (1 / solid.volume) * solid.inertia;
  const SymMat3d spread = diagonal(0.5 * (I.xx + I.yy + I.zz)) - I;
  const Principal principal = principal_of(spread);
  return {solid.volume, solid.center, spread, principal.axes, tightest_of(hull, principal)};
}

}  // namespace murosimf::geometry
