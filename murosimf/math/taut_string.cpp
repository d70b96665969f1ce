#include "murosimf/math/taut_string.h"

#include <algorithm>
#include <cmath>

#include "murosimf/math/assert.h"
#include "murosimf/math/quaternion.h"

namespace murosimf {
namespace {

constexpr double none = 1e-15;  // [m] lengths below are zero

struct Point {
  double x = 0, y = 0;
};
Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
Point operator*(double s, Point a) { return {s * a.x, s * a.y}; }
double dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }
double cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }
double length(Point a) { return std::sqrt(dot(a, a)); }
Point quarter(Point a) { return {-a.y, a.x}; }

struct Arc {
  Point first, second;
  double length = 0;
};

Point nearest_to_center(Point a, Point b) {
  const Point along = b - a;
  MUROSIMF_ASSERT(dot(along, along) > 0);
  return a + std::clamp(-dot(along, a) / dot(along, along), 0.0, 1.0) * along;
}

/// Whether p is in the angle between -a and -b.
bool is_opposite(Point a, Point b, Point p) {
  const double turn = cross(a, b);
  return turn * cross(a, p) < 0 && turn * cross(p, b) < 0;
}

std::optional<Arc> outside(Point a, Point b, double r, const std::optional<Point>& side) {
  if (length(a) < r || length(b) < r || length(b - a) < none) return std::nullopt;
  const double turn = std::atan2(cross(a, b), dot(a, b));
  const double tangents = std::acos(r / length(a)) + std::acos(r / length(b));
  const bool longer = side && is_opposite(a, b, *side);
  if (!longer && std::abs(turn) <= tangents) return std::nullopt;
  const double sense = (turn < 0) == longer ? 1 : -1;
  const auto tangent = [&](Point p, double quarters) {
    const double square = dot(p, p);
    MUROSIMF_ASSERT(square >= r * r);
    return (r / square) * (r * p + (quarters * std::sqrt(square - r * r)) * quarter(p));
  };
  const double angle = (longer ? 2 * pi - std::abs(turn) : std::abs(turn)) - tangents;
  return Arc{tangent(a, sense), tangent(b, -sense), r * angle};
}

/// Through the circle, at the point t from which both tangents of the path make the same angle with the radius: the length |a t| + |t b| is
/// convex in the angle of t between a and b.
std::optional<Arc> through(Point a, Point b, double r) {
  if (length(a) <= r || length(b) <= r || length(b - a) < none) return std::nullopt;
  if (length(nearest_to_center(a, b)) <= r) return std::nullopt;
  const double start = std::atan2(a.y, a.x), turn = std::atan2(cross(a, b), dot(a, b));
  if (std::abs(turn) > pi - 1e-9) return std::nullopt;
  const auto at = [&](double share) {
    return r * Point{std::cos(start + share * turn), std::sin(start + share * turn)};
  };
  double low = 0, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    const Point t = at(middle), way = turn * quarter(t);
    const double slope = dot(way, t - a) / length(t - a) + dot(way, t - b) / length(t - b);
    (slope < 0 ? low : high) = middle;
  }
  const Point t = at(0.5 * (low + high));
  return Arc{t, t, 0};
}

/// The unit vectors of the plane in which the string bends.
struct Axes {
  Vec3d x, y;
};

Axes plane_of(const StringObstacle& obstacle, const Vec3d& a, const Vec3d& b) {
  if (obstacle.cylinder) return {{1, 0, 0}, {0, 1, 0}};
  MUROSIMF_ASSERT(norm(a) > 0);
  const Vec3d x = (1 / norm(a)) * a;
  Vec3d normal = cross(a, b);
  if (norm(normal) < none) {  // a, b and the center are in a line: all planes are alike
    const bool along_z = std::abs(x.z) > 0.5;
    normal = cross(x, along_z ? Vec3d{1, 0, 0} : Vec3d{0, 0, 1});
  }
  return {x, cross((1 / norm(normal)) * normal, x)};
}

}  // namespace

std::optional<StringContact> touch(const StringObstacle& obstacle, const Vec3d& a, const Vec3d& b) noexcept {
  const double r = obstacle.radius;
  if (!(r > none) || norm(a) < none || norm(b) < none) return std::nullopt;
  const Axes axes = plane_of(obstacle, a, b);
  const auto across = [&](const Vec3d& p) { return Point{dot(p, axes.x), dot(p, axes.y)}; };
  std::optional<Point> side;
  if (obstacle.sided) {
    const Point s = across(obstacle.side);
    if (length(s) > none) side = (1 / length(s)) * s;
  }
  const bool ring = obstacle.sided && norm(obstacle.side) < r;
  const Point from = across(a), to = across(b);
  const auto arc = ring ? through(from, to, r) : outside(from, to, r, side);
  if (!arc) return std::nullopt;
  const auto lift = [&](Point p, double z) { return p.x * axes.x + p.y * axes.y + Vec3d{0, 0, z}; };
  if (!obstacle.cylinder) return StringContact{lift(arc->first, 0), lift(arc->second, 0), arc->length};
  const double before = length(arc->first - from), after = length(to - arc->second);
  const double whole = before + arc->length + after;
  const double slope = whole > none ? (b.z - a.z) / whole : 0;
  const double rise = slope * arc->length, z = a.z + slope * before;
  return StringContact{lift(arc->first, z), lift(arc->second, z + rise), std::hypot(arc->length, rise)};
}

double string_length(std::span<const StringPart> parts) noexcept {
  double sum = 0;
  lay_string(
      parts, [&](std::size_t, const Vec3d& a, std::size_t, const Vec3d& b) { sum += norm(b - a); },
      [&](double length) { sum += length; });
  return sum;
}

}  // namespace murosimf
