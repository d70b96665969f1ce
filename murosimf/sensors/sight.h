/// sight.h - how much of a body is in sight.
///
/// A body is looked at by nine points: the origin of its base, and eight near its outline as the eye sees it. For an
/// outline point, the shape that reaches farthest in one of eight directions across the line of sight is taken, and of
/// it the point at 0.8 of the way from its middle to its farthest point: inside the shape, so that only other bodies
/// can hide it. A point is free if the first thing on the ray towards it is the body itself, or nothing.
#pragma once

#include <span>

#include "murosimf/collision/queries.h"

namespace murosimf::sensors {

/// A body that is looked at.
struct Seen {
  const Entity* entity = nullptr;
  std::span<const Vec3d> r;                           ///< [m] of its objects, world frame
  std::span<const Mat3d> R;                           ///< their axes to world axes
  std::span<const collision::CollidingShape> shapes;  ///< none: it has no outline
};

/// The part [1] of the nine points that are free from the place `eye` [m], world frame; `without`: a transparent entity.
[[nodiscard]] double share_in_sight(collision::QueryScene& scene, const Vec3d& eye, const Entity* without,
                                    const Seen& body) noexcept;

/// True if that part is more than 0 and at least `share` [1]; looks at no more points than it takes to know.
[[nodiscard]] bool is_in_sight(collision::QueryScene& scene, const Vec3d& eye, const Entity* without, const Seen& body,
                               double share) noexcept;

}  // namespace murosimf::sensors
