/// continuous_collision.h - fast bodies without joints stop where they meet something between two steps.
///
/// Contact is looked for at the ends of steps: a ball of 15 m/s moves by 75 mm in 5 ms, and may be in front of a post at one end and behind
/// it at the other. Where a body of one shape is about to move by more than half of its own or the other's radius, the time t of the first
/// touch is worked out by conservative advancement: with n and d the direction and length of the shortest way to a convex shape and v the
/// velocity relative to it, the plane across that way parts the two until
///
///     t <- t + d / (v . n)        v . n <= 0: they never meet
///
/// The body then ends its step there, `touching_depth` deep, in the place of r + v dt:
///
///     separation = -(dt - t) v + touching_depth v / |v|
///
/// Its velocity stays: contact of the next step begins where the two have met. The rest of the step is lost, less than |v| dt of way. A body that
/// is no sphere is taken for the largest sphere about its middle that is as thick as it. Two such bodies share the way.
/// Assumes: the other one moves with the velocity of the point that is nearest at the beginning; contact forces of this step, which are
/// not known yet, bend the way by less than the thinner one's radius.
/// Source: Mirtich, Impulse-based Dynamic Simulation of Rigid Body Systems, 1996, sec. 2.3 (conservative advancement); the way back:
/// the project's own.
#pragma once

#include <optional>
#include <span>

#include "murosimf/model/shape.h"

namespace murosimf::collision {

struct MovingEntity;
class StaticCompound;

/// [m] so that the next step finds the contact.
inline constexpr double touching_depth = 1e-4;

/// [s] when a sphere that moves with `velocity` [m/s], relative to the shape, first touches it within `dt` [s]. Nothing if it does not, or
/// if they touch already.
[[nodiscard]] std::optional<double> time_of_touch(const Vec3d& center, double radius, const Vec3d& velocity,
                                                  const Shape& shape, const Transformd& at, double dt);

/// Adds to `separation` of the fast ones; after contacts of the step have been found.
void stop_at_touch(std::span<MovingEntity> moving_entities, const StaticCompound& environment, double dt) noexcept;

}  // namespace murosimf::collision
