#include "murosimf/geometry/fitting_frame.h"

#include <algorithm>
#include <cmath>
#include <ranges>
#include <vector>

#include <Eigen/Eigenvalues>

#include "murosimf/geometry/mesh_mass.h"
#include "murosimf/math/assert.h"

namespace murosimf::geometry {
namespace {

constexpr double alike = 1e-4;           // [1] second moments that differ by less leave their axes free
constexpr double clearly_less = 1e-9;    // [1] rounding must not choose between frames
constexpr double shortest_edge = 1e-12;  // [1] its square over the area of the outline's rectangle

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

struct Point {
  double x, y;  ///< [m]
};

/// Twice the area of the triangle; positive if it runs counterclockwise.
double turn(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Adds the points of one side of the outline, from the first to the last but one.
template <class Points>
void add_side(const Points& points, std::vector<Point>& outline) {
  // the lower side and, on the reversed points, the upper one: points to the right of the line so far are inside
  const std::size_t begin = outline.size();
  for (const Point& p : points) {
    while (outline.size() >= begin + 2 && turn(outline[outline.size() - 2], outline.back(), p) <= 0) outline.pop_back();
    outline.push_back(p);
  }
  outline.pop_back();
}

/// Corners of the hull seen along the z axis of the frame, counterclockwise.
/// Source: Andrew, "Another efficient algorithm for convex hulls in two dimensions", IPL 9 (1979).
std::vector<Point> outline_of(const ConvexHull& hull, const Mat3d& frame) {
  std::vector<Point> points, outline;
  MUROSIMF_ASSERT(!hull.vertices.empty());
  for (const Vec3d& v : hull.vertices) points.push_back({dot(frame.x, v), dot(frame.y, v)});
  std::ranges::sort(points, [](const Point& a, const Point& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  add_side(points, outline);
  add_side(std::views::reverse(points), outline);
  return outline;
}

/// Area of the rectangle around the outline with a side along the unit vector `u`.
double area_along(const std::vector<Point>& outline, const Point& u) {
  MUROSIMF_ASSERT(!outline.empty());
  double low_x = 1e300, high_x = -1e300, low_y = 1e300, high_y = -1e300;
  for (const Point& p : outline) {
    const double x = u.x * p.x + u.y * p.y, y = u.x * p.y - u.y * p.x;
    low_x = std::min(low_x, x);
    high_x = std::max(high_x, x);
    low_y = std::min(low_y, y);
    high_y = std::max(high_y, y);
  }
  return (high_x - low_x) * (high_y - low_y);
}

double volume_in(const ConvexHull& hull, const Mat3d& frame) {
  const auto [low, high] = bounds_in(hull, frame);
  return (high.x - low.x) * (high.y - low.y) * (high.z - low.z);
}

/// The frame with the given z axis whose other axes frame the hull in the smallest rectangle: one side of it lies on an
/// edge of the outline.
/// Source: Freeman, Shapira, "Determining the minimum-area encasing rectangle for an arbitrary closed curve", CACM 18
/// (1975).
Mat3d frame_about(const ConvexHull& hull, const Vec3d& z) {
  const Vec3d some = std::fabs(z.x) < 0.6 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
  // a direction that is not nearly parallel to z
  const Vec3d across = cross(z, some);
  const Vec3d first = (1 / norm(across)) * across;
  const Mat3d start{first, cross(z, first), z};
  const auto outline = outline_of(hull, start);
  Point best{1, 0};
  double least = area_along(outline, best);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point &a = outline[i], &b = outline[(i + 1) % outline.size()];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    if (length * length < shortest_edge * least) continue;
    const Point u{(b.x - a.x) / length, (b.y - a.y) / length};
    const double area = area_along(outline, u);
    if (area >= (1 - clearly_less) * least) continue;
    least = area;
    best = u;
  }
  const Vec3d x = best.x * start.x + best.y * start.y;
  return {x, cross(z, x), z};
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
  MUROSIMF_ASSERT(!hull.vertices.empty());
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
  MUROSIMF_ASSERT(hull.normals.size() == hull.faces.size());
  const SolidMass solid = solid_mass(hull);
  const SymMat3d I = (1 / solid.volume) * solid.inertia;
  // second moments of the volume, from moments of inertia: int x^2 = (Iyy + Izz - Ixx) / 2
  const SymMat3d spread = diagonal(0.5 * (I.xx + I.yy + I.zz)) - I;
  const Principal principal = principal_of(spread);
  return {solid.volume, solid.center, spread, principal.axes, tightest_of(hull, principal)};
}

}  // namespace murosimf::geometry
