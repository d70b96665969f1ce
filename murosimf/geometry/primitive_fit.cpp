#include "murosimf/geometry/primitive_fit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "murosimf/geometry/fitting_frame.h"

namespace murosimf::geometry {
namespace {

constexpr int trials = 16384;           // points in the bounding box
constexpr double least_slender = 1e-3;  // [1] straight part of a capsule over its diameter
constexpr double same_overlap = 0.005;  // [1] what the points cannot tell apart

/// Ratio of the second moments of a capsule of radius 1, along its axis over across.
/// A half ball has its center 3/8 from its flat side, and the second moment 1/5 about that side.
double capsule_ratio(double t) {
  const double tube = 2 * t, balls = 4.0 / 3.0;  // volumes over pi
  const double along = tube * t * t / 3 + balls * (t * t + 0.75 * t + 0.2);
  return along / (tube / 4 + balls / 5);
}

/// Half length of the straight part over the radius: capsule_ratio rises with it.
double capsule_slenderness(double ratio) {
  double low = least_slender, high = std::max(1.0, ratio);
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (capsule_ratio(middle) < ratio ? low : high) = middle;
  }
  return low;
}

/// The axes of `frame` in a cyclic order that ends with the given one.
Mat3d turned_to(const Mat3d& frame, int axis) {
  if (axis == 0) return {frame.y, frame.z, frame.x};
  if (axis == 1) return {frame.z, frame.x, frame.y};
  return frame;
}

FittedPrimitive capsule_of(const SolidShape& solid) {
  const Vec3d s = solid.moments(solid.principal);
  const int axis = s.x >= s.y && s.x >= s.z ? 0 : s.y >= s.z ? 1 : 2;
  const Mat3d frame = turned_to(solid.principal, axis);
  const Vec3d m = solid.moments(frame);
  const double t = capsule_slenderness(2 * m.z / (m.x + m.y));
  const double radius = std::cbrt(solid.volume / (pi * (4.0 / 3.0 + 2 * t)));
  return {Capsule{radius, t * radius}, solid.center, frame};
}

/// The axis whose two others are most alike.
int round_axis(const Vec3d& s) {
  const auto difference = [](double a, double b) { return std::fabs(std::log(a / b)); };
  const std::array<double, 3> differences{difference(s.y, s.z), difference(s.x, s.z), difference(s.x, s.y)};
  return static_cast<int>(std::ranges::min_element(differences) - differences.begin());
}

FittedPrimitive cylinder_of(const SolidShape& solid) {
  const Mat3d frame = turned_to(solid.principal, round_axis(solid.moments(solid.principal)));
  const Vec3d m = solid.moments(frame);
  // second moments h^2 / 3 along and r^2 / 4 across
  const double t = std::sqrt(0.75 * 2 * m.z / (m.x + m.y));
  const double radius = std::cbrt(solid.volume / (2 * pi * t));
  return {Cylinder{radius, t * radius}, solid.center, frame};
}

FittedPrimitive box_of(const SolidShape& solid) {
  const Vec3d m = solid.moments(solid.tightest);
  const Vec3d half{std::sqrt(3 * m.x), std::sqrt(3 * m.y), std::sqrt(3 * m.z)};
  return {Box{std::cbrt(solid.volume / (8 * half.x * half.y * half.z)) * half}, solid.center, solid.tightest};
}

FittedPrimitive primitive_of(const SolidShape& solid, PrimitiveKind kind) {
  if (kind == PrimitiveKind::sphere) return {Sphere{std::cbrt(0.75 * solid.volume / pi)}, solid.center, {}};
  if (kind == PrimitiveKind::capsule) return capsule_of(solid);
  if (kind == PrimitiveKind::cylinder) return cylinder_of(solid);
  return box_of(solid);
}

/// Whether a point of the shape's frame is inside; of the kinds that are fitted.
struct Contains {
  Vec3d p;

  [[nodiscard]] double across() const { return p.x * p.x + p.y * p.y; }
  bool operator()(const Sphere& s) const { return dot(p, p) <= s.radius * s.radius; }
  bool operator()(const Capsule& s) const {
    const double beyond = std::max(0.0, std::fabs(p.z) - s.half_length);
    return across() + beyond * beyond <= s.radius * s.radius;
  }
  bool operator()(const Cylinder& s) const {
    return across() <= s.radius * s.radius && std::fabs(p.z) <= s.half_length;
  }
  bool operator()(const Box& s) const {
    return std::fabs(p.x) <= s.half_size.x && std::fabs(p.y) <= s.half_size.y && std::fabs(p.z) <= s.half_size.z;
  }
  bool operator()(const Ellipsoid&) const { return false; }
  bool operator()(const Plane&) const { return false; }
  bool operator()(const Convex&) const { return false; }
};

bool is_inside(const ConvexHull& hull, const Vec3d& point) {
  for (std::size_t i = 0; i < hull.faces.size(); ++i) {
    if (dot(hull.normals[i], point - hull.vertices[hull.faces[i][0]]) > 0) return false;
  }
  return true;
}

/// Points of the hull, evenly spread and in no line with any axis: multiples of powers of 1 / g with g^4 = g + 1.
/// Source: Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences" (2018).
std::vector<Vec3d> points_inside(const ConvexHull& hull, const Mat3d& frame) {
  constexpr double g = 1.2207440846057596;
  const auto fraction = [](double x) { return x - std::floor(x); };
  const auto [low, high] = bounds_in(hull, frame);
  const Vec3d size = high - low;
  std::vector<Vec3d> points;
  for (int i = 0; i < trials; ++i) {
    const Vec3d share{fraction(0.5 + i / g), fraction(0.5 + i / (g * g)), fraction(0.5 + i / (g * g * g))};
    const Vec3d point = frame * (low + Vec3d{size.x * share.x, size.y * share.y, size.z * share.z});
    if (is_inside(hull, point)) points.push_back(point);
  }
  return points;
}

/// Both have the same volume, so points inside the hull tell everything.
double overlap_of(const FittedPrimitive& fitted, const std::vector<Vec3d>& points) {
  if (points.empty()) return 0;
  const auto both = std::ranges::count_if(points, [&](const Vec3d& point) {
    return std::visit(Contains{transposed_times(fitted.orientation, point - fitted.position)}, fitted.shape);
  });
  return static_cast<double>(both) / static_cast<double>(points.size());
}

}  // namespace

FittedPrimitive fit_primitive(const ConvexHull& hull, PrimitiveKind kind) {
  const SolidShape solid = solid_shape(hull);
  const auto points = points_inside(hull, solid.tightest);
  const auto fit = [&](PrimitiveKind one) {
    FittedPrimitive fitted = primitive_of(solid, one);
    fitted.overlap = overlap_of(fitted, points);
    return fitted;
  };
  if (kind != PrimitiveKind::best) return fit(kind);
  FittedPrimitive best = fit(PrimitiveKind::sphere);
  for (const auto other : {PrimitiveKind::capsule, PrimitiveKind::box, PrimitiveKind::cylinder}) {
    const FittedPrimitive fitted = fit(other);
    if (fitted.overlap > best.overlap + same_overlap) best = fitted;
  }
  return best;
}

}  // namespace murosimf::geometry
