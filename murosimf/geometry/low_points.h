/// low_points.h - the points of a shape that can be below a plane.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "murosimf/geometry/spread.h"
#include "murosimf/model/shape.h"

namespace murosimf::geometry {

/// Calls `emit(corner, point)` for each corner of a box at `center` [m] with these axes, world frame.
template <class S, class Emit>
MUROSIMF_INLINE void for_corners(const Box& box, const Vec3<S>& center, const Mat3<S>& axes, const Emit& emit) {
  const Vec3<S> x = box.half_size.x * axes.x, y = box.half_size.y * axes.y, z = box.half_size.z * axes.z;
  const Vec3<S> sides[4]{-x - y, x - y, y - x, x + y};
  for (std::uint32_t i = 0; i < 4; ++i) emit(i, center + (sides[i] - z));
  for (std::uint32_t i = 0; i < 4; ++i) emit(i + 4, center + (sides[i] + z));
}

/// Calls `emit(feature, point, radius)` for each point of the shape that may be the lowest; world frame. The lowest point
/// of the shape is always among them; of a polyhedron with more than eight vertices below the plane only one about as deep
/// (spread.h). Features rise from point to point. `radius` [m]: of the surface that rolls there.
struct LowPoints {
  Vec3d center;  ///< [m] of the shape, world frame
  Mat3d R;       ///< shape axes to world axes
  Vec3d n;       ///< [1] the plane's normal
  /// [m] of the plane: n . x of its points. Only polyhedra ask for it; at minus infinity they have only the lowest.
  double height = -std::numeric_limits<double>::infinity();

  template <class Emit>
  void operator()(const Sphere& s, const Emit& emit) const {
    emit(0u, center - s.radius * n, s.radius);
  }
  template <class Emit>
  void operator()(const Box& s, const Emit& emit) const {
    for_corners(s, center, R, [&](std::uint32_t corner, const Vec3d& point) { emit(corner, point, 0.0); });
  }
  template <class Emit>
  void operator()(const Capsule& s, const Emit& emit) const {
    emit(0u, center - s.half_length * R.z - s.radius * n, s.radius);
    emit(1u, center + s.half_length * R.z - s.radius * n, s.radius);
  }
  template <class Emit>
  void operator()(const Cylinder& s, const Emit& emit) const {
    // on each cap: the lowest rim point, the opposite one, and the two between
    const Vec3d down = tangential(-n, R.z);
    const double size = norm(down);
    const Vec3d first = size > 1e-9 ? (1.0 / size) * down : R.x;
    const Vec3d second = cross(R.z, first);
    const double arm = std::abs(dot(R.z, n)) < 0.5 ? s.radius : 0.0;  // lying it rolls, standing it does not
    for (std::uint32_t cap = 0; cap < 2; ++cap) {
      const Vec3d middle = center + (cap == 0 ? -s.half_length : s.half_length) * R.z;
      emit(4 * cap + 0, middle + s.radius * first, arm);
      emit(4 * cap + 1, middle + s.radius * second, arm);
      emit(4 * cap + 2, middle - s.radius * second, arm);
      emit(4 * cap + 3, middle - s.radius * first, arm);
    }
  }
  template <class Emit>
  void operator()(const Ellipsoid& s, const Emit& emit) const {
    // support point: semi-axes squared times the direction, divided by its scaled length
    const Vec3d d = transposed_times(R, -n);
    const Vec3d a{s.semi_axes.x * d.x, s.semi_axes.y * d.y, s.semi_axes.z * d.z};
    const Vec3d b{s.semi_axes.x * a.x, s.semi_axes.y * a.y, s.semi_axes.z * a.z};
    emit(0u, center + R * ((1.0 / norm(a)) * b), std::min({s.semi_axes.x, s.semi_axes.y, s.semi_axes.z}));
  }
  template <class Emit>
  void operator()(const Plane&, const Emit&) const {}
  /// Of a polyhedron up to eight vertices that are below the plane, or the lowest if none is.
  template <class Emit>
  void operator()(const Convex& s, const Emit& emit) const {
    const auto& vertices = s.hull->vertices;
    const Vec3d up = transposed_times(R, n);
    const double level = height - dot(n, center);
    const auto depth = [&](int i) { return level - dot(up, vertices[i]); };
    const auto point = [&](int i) { return vertices[i]; };
    const Chosen chosen = choose_spread(static_cast<int>(vertices.size()), point, depth);
    for (int k = 0; k < chosen.count; ++k) {
      emit(static_cast<std::uint32_t>(chosen.index[k]), center + R * vertices[chosen.index[k]], 0.0);
    }
    if (chosen.count == 0) emit_lowest(s, emit);
  }

 private:
  template <class Emit>
  void emit_lowest(const Convex& s, const Emit& emit) const {
    const auto& vertices = s.hull->vertices;
    const Vec3d up = transposed_times(R, n);
    std::size_t lowest = 0;
    for (std::size_t i = 1; i < vertices.size(); ++i) {
      if (dot(up, vertices[i]) < dot(up, vertices[lowest])) lowest = i;
    }
    emit(static_cast<std::uint32_t>(lowest), center + R * vertices[lowest], 0.0);
  }
};

/// How many different features LowPoints gives the shape.
[[nodiscard]] inline std::uint32_t low_point_features(const Shape& shape) {
  const auto* convex = std::get_if<Convex>(&shape);
  return convex ? std::max<std::uint32_t>(8, static_cast<std::uint32_t>(convex->hull->vertices.size())) : 8;
}

}  // namespace murosimf::geometry
