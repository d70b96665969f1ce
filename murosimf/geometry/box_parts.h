/// box_parts.h - corners, edges and faces of a box.
#pragma once

#include <array>
#include <cmath>

#include "murosimf/geometry/manifold.h"
#include "murosimf/geometry/outline.h"
#include "murosimf/geometry/segments.h"
#include "murosimf/model/shape.h"

namespace murosimf::geometry {

/// A box in the world, its axes as an array.
struct BoxParts {
  Vec3d center;
  std::array<Vec3d, 3> axis;
  std::array<double, 3> half;

  BoxParts(const Box& box, const Transformd& at)
      : center(at.position),
        axis{at.orientation.x, at.orientation.y, at.orientation.z},
        half{box.half_size.x, box.half_size.y, box.half_size.z} {}

  /// The axis nearest to a direction.
  [[nodiscard]] int axis_along(const Vec3d& n) const {
    const double x = std::abs(dot(axis[0], n)), y = std::abs(dot(axis[1], n)), z = std::abs(dot(axis[2], n));
    return x >= y && x >= z ? 0 : (y >= z ? 1 : 2);
  }
  /// The face at the end of axis i that looks along n. Corners are named by bits, as in LowPoints.
  template <int Most>
  void face(int i, const Vec3d& n, Outline<Most>& outline) const {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const bool up = dot(axis[i], n) > 0;
    outline.normal = up ? axis[i] : -axis[i];
    outline.name = 8u + 2u * i + (up ? 1u : 0u);
    outline.count = 0;
    const Vec3d middle = center + half[i] * outline.normal;
    for (int corner = 0; corner < 4; ++corner) {
      const int turn = up ? corner : 3 - corner;  // counterclockwise seen from outside
      const bool right = turn == 0 || turn == 3, far = turn < 2;
      const Vec3d point = middle + (right ? half[j] : -half[j]) * axis[j] + (far ? half[k] : -half[k]) * axis[k];
      outline.add(point, (up ? 1u << i : 0u) | (right ? 1u << j : 0u) | (far ? 1u << k : 0u));
    }
    outline.name_sides();
  }
  /// The edge along axis i that is farthest along n.
  [[nodiscard]] Segment edge(int i, const Vec3d& n) const {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const Vec3d middle =
        center + std::copysign(half[j], dot(axis[j], n)) * axis[j] + std::copysign(half[k], dot(axis[k], n)) * axis[k];
    return {middle, half[i] * axis[i]};
  }
  /// Name of that edge.
  [[nodiscard]] std::uint32_t edge_name(int i, const Vec3d& n) const {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    return 16u + 4u * i + (dot(axis[j], n) > 0 ? 2u : 0u) + (dot(axis[k], n) > 0 ? 1u : 0u);
  }
};

}  // namespace murosimf::geometry
