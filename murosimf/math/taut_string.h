/// taut_string.h - the shortest string through points and around spheres and cylinders.
///
/// A string from a to b around a circle of radius r runs along the tangents of both points and along the arc between them. With p' the
/// vector p turned by a quarter, w_p = sqrt(|p|^2 - r^2), theta the angle between a and b, sigma = 1 where it goes counterclockwise, else -1:
///
///     t_a = r/|a|^2 (r a + sigma w_a a'),   t_b = r/|b|^2 (r b - sigma w_b b')
///     arc = r (theta - acos(r/|a|) - acos(r/|b|)), the longer way with 2 pi - theta
///
/// Around a sphere that is so in the plane of a, b and its center, since geodesics of spheres are great circles. Around a cylinder it is so
/// across the axis; along the axis the string rises evenly with its length across, since it is straight on the unrolled surface.
/// The string touches an obstacle that the straight line meets, and goes the shorter way; if its side is in the angle between -a and -b, it
/// goes the longer way, which passes there, and does so also where the straight line meets nothing. A side inside of the obstacle makes a
/// ring of it: where the straight line would miss it, the string goes through the point t of the circle at which |a t| + |t b| is smallest.
/// Source: elementary geometry (geodesics of sphere and cylinder); when a string touches: MuJoCo documentation, "Tendon", spatial tendons.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "murosimf/math/transform.h"

namespace murosimf {

struct StringObstacle {
  double radius = 0;      ///< [m] 0: nothing is there
  bool cylinder = false;  ///< about z and without ends; else a sphere
  bool sided = false;     ///< the string is on one side
  Vec3d side{};           ///< [m] a point there, obstacle frame
};

struct StringContact {
  Vec3d first, second;  ///< [m] where the string arrives and leaves, obstacle frame
  double length = 0;    ///< [m] on the obstacle
};

/// The part of a string from a to b [m] that touches an obstacle, all in its frame; nothing if the string is straight, also if a or b is
/// inside of it.
[[nodiscard]] std::optional<StringContact> touch(const StringObstacle& obstacle, const Vec3d& a,
                                                 const Vec3d& b) noexcept;

/// A point of a string, or an obstacle between two of its points.
struct StringPart {
  Transformd place;           ///< of the point (its position) or the obstacle
  StringObstacle obstacle{};  ///< radius 0 for points: the first and last part, and neighbors of obstacles
};

/// Calls straight(i, x_i, j, x_j) for each straight piece, with the parts at its ends and the ends [m], and along(length) for each piece on an
/// obstacle [m], in their order.
template <class Straight, class Along>
void lay_string(std::span<const StringPart> parts, const Straight& straight, const Along& along) noexcept {
  for (std::size_t i = 0; i + 1 < parts.size();) {
    const std::size_t last = parts[i + 1].obstacle.radius > 0 && i + 2 < parts.size() ? i + 2 : i + 1;
    const Vec3d &a = parts[i].place.position, &b = parts[last].place.position;
    std::optional<StringContact> contact;
    const auto& [center, turn] = parts[i + 1].place;
    if (last == i + 2) {
      const Mat3d back = transpose(turn);
      contact = touch(parts[i + 1].obstacle, back * (a - center), back * (b - center));
    }
    if (contact) {
      straight(i, a, i + 1, center + turn * contact->first);
      along(contact->length);
      straight(i + 1, center + turn * contact->second, last, b);
    } else {
      straight(i, a, last, b);
    }
    i = last;
  }
}

/// [m] Length of the whole string.
[[nodiscard]] double string_length(std::span<const StringPart> parts) noexcept;

}  // namespace murosimf
