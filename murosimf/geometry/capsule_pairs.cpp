// Capsules are segments with a margin: the least shift that parts them is the margins less the distance of the segments,
// or, if a segment is inside a box, the margin more than the way out of the sum of the two bodies.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "murosimf/geometry/box_parts.h"
#include "murosimf/geometry/build_manifold.h"
#include "murosimf/geometry/pair_tests.h"

namespace murosimf::geometry {
namespace {

Segment axis_of(const Capsule& capsule, const Transformd& at) {
  return {at.position, capsule.half_length * at.orientation.z};
}

/// Way out where two axes cross: upright on both, or on the longer one if they are parallel.
Vec3d across(const Segment& a, const Segment& b) {
  Vec3d way = cross(a.half, b.half);
  const double aa = dot(a.half, a.half), bb = dot(b.half, b.half);
  if (dot(way, way) <= 1e-24 * aa * bb) {
    const Vec3d& along = aa > bb ? a.half : b.half;
    const bool flat_x = std::abs(along.x) <= std::abs(along.y) && std::abs(along.x) <= std::abs(along.z);
    way = cross(along,
                flat_x ? Vec3d{1, 0, 0} : (std::abs(along.y) <= std::abs(along.z) ? Vec3d{0, 1, 0} : Vec3d{0, 0, 1}));
  }
  const double length = norm(way);
  return length > 0 ? (1 / length) * way : Vec3d{0, 0, 1};
}

/// A segment in the frame of a box.
struct SegmentAtBox {
  std::array<double, 3> half;       // of the box
  std::array<double, 3> middle, u;  // of the segment; u: unit
  double length = 0;                // half of it

  [[nodiscard]] double slope(double t) const {
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
      const double p = middle[i] + t * u[i];
      sum += u[i] * (p - std::clamp(p, -half[i], half[i]));
    }
    return sum;
  }
  /// Place along the segment that is nearest to the box. The square of the distance is convex and quadratic between the
  /// places where the line passes a side plane of the box.
  [[nodiscard]] double nearest_place() const {
    double low = -length, high = length;
    double slope_low = slope(low), slope_high = slope(high);
    if (slope_low >= 0) return low;
    if (slope_high <= 0) return high;
    for (int i = 0; i < 3; ++i) {
      for (const double side : {-half[i], half[i]}) {
        const double t = (side - middle[i]) / u[i];
        if (!(t > low && t < high)) continue;
        const double at = slope(t);
        (at > 0 ? high : low) = t;
        (at > 0 ? slope_high : slope_low) = at;
      }
    }
    return low + (high - low) * slope_low / (slope_low - slope_high);
  }
  /// From the nearest point of the box to place t.
  [[nodiscard]] Vec3d gap(double t) const {
    std::array<double, 3> g;
    for (int i = 0; i < 3; ++i) {
      const double p = middle[i] + t * u[i];
      g[i] = p - std::clamp(p, -half[i], half[i]);
    }
    return {g[0], g[1], g[2]};
  }
};

/// The direction in which the segment and the box are farthest apart, or overlap least, among normals of the faces of
/// their sum: those of the box, and those upright on an edge and the segment.
struct FaceOfSum {
  double apart = -std::numeric_limits<double>::infinity();
  std::array<double, 3> out{};  // from the box to the segment

  void see(double separation, const std::array<double, 3>& direction) {
    if (separation <= apart) return;
    apart = separation;
    out = direction;
  }
};

FaceOfSum face_of_sum(const SegmentAtBox& s, double enough) {
  FaceOfSum best;
  for (int i = 0; i < 3; ++i) {
    std::array<double, 3> out{};
    out[i] = s.middle[i] < 0 ? -1 : 1;
    best.see(std::abs(s.middle[i]) - s.length * std::abs(s.u[i]) - s.half[i], out);
    if (best.apart >= enough) return best;
  }
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const double size = std::hypot(s.u[j], s.u[k]);
    if (size < 1e-9) continue;
    const double way = (s.middle[k] * s.u[j] - s.middle[j] * s.u[k]) / size;
    const double sign = way < 0 ? -1 : 1;
    std::array<double, 3> out{};
    out[j] = -sign * s.u[k] / size;
    out[k] = sign * s.u[j] / size;
    best.see(std::abs(way) - (s.half[j] * std::abs(out[j]) + s.half[k] * std::abs(out[k])), out);
  }
  return best;
}

/// From the box to the segment; box frame.
bool part(const SegmentAtBox& s, double radius, Penetration& penetration) {
  const FaceOfSum face = face_of_sum(s, radius);
  if (face.apart >= radius) return false;
  penetration = {{face.out[0], face.out[1], face.out[2]}, radius - face.apart};
  if (face.apart <= 0) return true;
  const Vec3d gap = s.gap(s.nearest_place());
  const double distance = norm(gap);
  if (distance >= radius) return false;
  if (distance > 1e-9 * (s.length + radius)) penetration = {(1 / distance) * gap, radius - distance};
  return true;
}

/// Place of the one point where a box and a capsule meet, if no flat side does.
Vec3d middle_point(const SegmentAtBox& s, const BoxParts& box, const Segment& axis, double radius, const Vec3d& out,
                   const Penetration& penetration) {
  const double t = s.nearest_place();
  const Vec3d gap = s.gap(t);
  Vec3d on_axis = axis.middle + (s.length > 0 ? t / s.length : 0.0) * axis.half;
  if (is_zero(gap)) {
    // the axis passes an edge of the box on its inner side
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
      const Segment edge = box.edge(i, out);
      const double upright = dot(edge.half, out);
      if (upright * upright > 1e-12 * dot(edge.half, edge.half)) continue;
      const auto [place, on_edge] = closest_places(axis, edge);
      const Vec3d way = tangential(axis.at(place) - edge.at(on_edge), out);
      if (dot(way, way) < least) {
        least = dot(way, way);
        on_axis = axis.at(place);
      }
    }
  }
  return on_axis + (0.5 * penetration.depth - radius) * out;
}

}  // namespace

bool collide_capsules(const Capsule& a, const Transformd& at_a, const Capsule& b, const Transformd& at_b,
                      // margins and segments: exact, and much cheaper than the general test
                      Manifold& found) {
  const Segment u = axis_of(a, at_a), v = axis_of(b, at_b);
  const auto [s, t] = closest_places(u, v);
  const Vec3d on_b = v.at(t), way = u.at(s) - on_b;
  const double sum = a.radius + b.radius, square = dot(way, way);
  if (!(square < sum * sum)) return false;
  const double distance = std::sqrt(square);
  const Vec3d normal = distance > 1e-12 * sum ? (1 / distance) * way : across(u, v);
  const Penetration penetration{normal, sum - distance};
  begin(penetration, found);
  if (add_side_by_side(penetration, u, a.radius, v, b.radius, 0, found)) {
    finish(penetration, found);
  } else {
    only_point(penetration, on_b + (b.radius - 0.5 * penetration.depth) * normal, 0, found);
  }
  return true;
}

bool collide_box_capsule(const Box& a, const Transformd& at_a, const Capsule& b, const Transformd& at_b,
                         Manifold& found) {
  const Vec3d middle = transposed_times(at_a.orientation, at_b.position - at_a.position);
  const Vec3d u = transposed_times(at_a.orientation, at_b.orientation.z);
  const SegmentAtBox segment{{a.half_size.x, a.half_size.y, a.half_size.z},
                             {middle.x, middle.y, middle.z},
                             {u.x, u.y, u.z},
                             b.half_length};
  Penetration local;
  if (!part(segment, b.radius, local)) return false;
  const Vec3d out = at_a.orientation * local.normal;
  const Penetration penetration{-out, local.depth};
  begin(penetration, found);
  const BoxParts box(a, at_a);
  const Segment axis = axis_of(b, at_b);
  const int i = box.axis_along(out);
  if (std::abs(dot(box.axis[i], out)) > flat) {
    Outline<4> face;
    box.face(i, out, face);
    Outline<4> side;
    side.add(axis.at(-1) - b.radius * out, 0);
    side.add(axis.at(1) - b.radius * out, 1);
    side.name_sides();
    clip_by_sides(side, face, out);
    add_points_below(side, face, out, found);
  } else {
    const int along = box.axis_along(at_b.orientation.z);
    add_side_by_side(penetration, box.edge(along, out), 0, axis, b.radius, box.edge_name(along, out), found);
  }
  if (found.count > 0) {
    finish(penetration, found);
  } else {
    only_point(penetration, middle_point(segment, box, axis, b.radius, out, penetration), 0, found);
  }
  return true;
}

}  // namespace murosimf::geometry
