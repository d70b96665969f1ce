#include "murosimf/geometry/volume_overlap.h"

#include <array>

namespace murosimf::geometry {
namespace detail {

double square_between(const BoundingCapsule& a, const BoundingCapsule& b) {
  const Vec3d &u = a.half_axis, &v = b.half_axis, w = a.middle - b.middle;
  const double uu = dot(u, u), vv = dot(v, v), uv = dot(u, v), uw = dot(u, w), vw = dot(v, w);
  const auto limited = [](double x) { return std::clamp(x, -1.0, 1.0); };
  const double parallel = uu * vv - uv * uv;
  double s = parallel > 1e-12 * uu * vv ? limited((uv * vw - vv * uw) / parallel) : 0;
  const double t = vv > 0 ? limited((uv * s + vw) / vv) : 0;
  s = uu > 0 ? limited((uv * t - uw) / uu) : 0;
  const Vec3d way = w + s * u - t * v;
  return dot(way, way);
}

namespace {

/// The squared distance of the points p + t u, -1 <= t <= 1, from a box about the origin: along t it is convex, and
/// its slope is linear between the places where the line crosses the planes of the box's sides.
struct LineAndBox {
  Vec3d p, u, half;

  [[nodiscard]] static double beyond(double x, double limit) { return x - std::clamp(x, -limit, limit); }
  [[nodiscard]] Vec3d out(double t) const {
    return {beyond(p.x + t * u.x, half.x), beyond(p.y + t * u.y, half.y), beyond(p.z + t * u.z, half.z)};
  }
  [[nodiscard]] double slope(double t) const { return dot(u, out(t)); }

  struct Bracket {
    double low = -1, high = 1;
  };
  /// Moves the end of the bracket that has the slope's sign to the crossing at t, if that is inside.
  void narrow(Bracket& bracket, double t) const {
    if (!(t > bracket.low && t < bracket.high)) return;
    (slope(t) <= 0 ? bracket.low : bracket.high) = t;
  }
  void narrow(Bracket& bracket, double from, double along, double side) const {
    if (along == 0) return;
    narrow(bracket, (side - from) / along);
    narrow(bracket, (-side - from) / along);
  }
  [[nodiscard]] double nearest() const {
    if (slope(-1) >= 0) return -1;
    if (slope(1) <= 0) return 1;
    Bracket bracket;
    narrow(bracket, p.x, u.x, half.x);
    narrow(bracket, p.y, u.y, half.y);
    narrow(bracket, p.z, u.z, half.z);
    const double low = slope(bracket.low), rise = slope(bracket.high) - low;
    return rise > 0 ? bracket.low - low / rise * (bracket.high - bracket.low) : bracket.low;
  }
};

}  // namespace

double square_between(const BoundingCapsule& capsule, const Obb& box) {
  const LineAndBox line{transposed_times(box.axes, capsule.middle - box.center),
                        transposed_times(box.axes, capsule.half_axis), box.half};
  const Vec3d out = line.out(line.nearest());
  return dot(out, out);
}

double face_gap(const Obb& a, const Obb& b) {
  const Vec3d way = b.center - a.center;
  const Vec3d in_a = componentwise_abs(transposed_times(a.axes, way));
  const Vec3d in_b = componentwise_abs(transposed_times(b.axes, way));
  const Mat3d turn = transpose(a.axes) * b.axes;  // axes of B in A
  const Mat3d spread{componentwise_abs(turn.x), componentwise_abs(turn.y), componentwise_abs(turn.z)};
  const Vec3d part_a = in_a - a.half - spread * b.half;
  const Vec3d part_b = in_b - b.half - transposed_times(spread, a.half);
  return std::max({part_a.x, part_a.y, part_a.z, part_b.x, part_b.y, part_b.z});
}

namespace {

/// True if one of the cross products of the axis `a_axis` of A with the axes of B parts the boxes. `i`: which axis of
/// A, in a cyclic order with `j` and `k`.
struct EdgeAxes {
  std::array<double, 3> way, half_a, half_b;    // in A's frame, along A's axes, along B's axes
  std::array<std::array<double, 3>, 3> C, abs;  // [i][j] axis i of A times axis j of B, and its size

  [[nodiscard]] bool parts(std::size_t i, std::size_t j) const {
    const std::size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
    const double reach_a = half_a[i1] * abs[i2][j] + half_a[i2] * abs[i1][j];
    const double reach_b = half_b[j1] * abs[i][j2] + half_b[j2] * abs[i][j1];
    return std::fabs(way[i2] * C[i1][j] - way[i1] * C[i2][j]) > reach_a + reach_b;
  }
};

}  // namespace
}  // namespace detail

bool overlap(const Obb& a, const Obb& b) {
  if (detail::face_gap(a, b) > 0) return false;
  const Vec3d way = transposed_times(a.axes, b.center - a.center);
  detail::EdgeAxes edges{{way.x, way.y, way.z}, {a.half.x, a.half.y, a.half.z}, {b.half.x, b.half.y, b.half.z}, {}, {}};
  constexpr double parallel = 1e-12;  // the cross product of parallel axes is rounding: it must not part anything
  const std::array<Vec3d, 3> axes_b{b.axes.x, b.axes.y, b.axes.z};
  for (std::size_t j = 0; j < 3; ++j) {
    const Vec3d axis = transposed_times(a.axes, axes_b[j]);
    edges.C[0][j] = axis.x;
    edges.C[1][j] = axis.y;
    edges.C[2][j] = axis.z;
    for (std::size_t i = 0; i < 3; ++i) edges.abs[i][j] = std::fabs(edges.C[i][j]) + parallel;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (edges.parts(i, j)) return false;
    }
  }
  return true;
}

bool ray_enters(const BoundingSphere& v, const Ray& ray, double limit) {
  const Vec3d way = v.center - ray.origin;
  const Vec3d off = way - std::clamp(dot(way, ray.direction), 0.0, limit) * ray.direction;
  return dot(off, off) <= v.radius * v.radius;
}

namespace {

/// The part of a ray between two parallel planes at +-half; false if nothing is left.
bool cut(double from, double along, double half, double& first, double& last) {
  if (along == 0) return abs(from) <= half;
  const double one = (-half - from) / along, other = (half - from) / along;
  first = std::max(first, std::min(one, other));
  last = std::min(last, std::max(one, other));
  return first <= last;
}

bool enters_box(const Vec3d& from, const Vec3d& along, const Vec3d& half, double limit) {
  double first = 0, last = limit;
  return cut(from.x, along.x, half.x, first, last) && cut(from.y, along.y, half.y, first, last) &&
         cut(from.z, along.z, half.z, first, last);
}

}  // namespace

bool ray_enters(const Aabb& v, const Ray& ray, double limit) {
  return enters_box(ray.origin - v.center, ray.direction, v.half, limit);
}

bool ray_enters(const Obb& v, const Ray& ray, double limit) {
  return enters_box(transposed_times(v.axes, ray.origin - v.center), transposed_times(v.axes, ray.direction), v.half,
                    limit);
}

bool ray_enters(const BoundingCapsule& v, const Ray& ray, double limit) {
  const double far_side = norm(v.middle - ray.origin) + size(v);
  const Vec3d half = 0.5 * std::min(limit, far_side) * ray.direction;
  return detail::within(detail::square_between(v, BoundingCapsule{ray.origin + half, half, 0}), v.radius);
}

}  // namespace murosimf::geometry
