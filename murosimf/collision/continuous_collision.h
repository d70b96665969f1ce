/// continuous_collision.h - fast bodies without joints stop where they meet something between two steps.
///
/// Contact is looked for at the ends of steps: a ball of 15 m/s moves by 75 mm in 5 ms, and may be in front of a post at one end and behind
/// it at the other; and contact is soft, so that it may be too late when it has come half through. Where a body of one shape is about to
/// move by more than half of its own or the other's radius, its core, the same with a radius that is less by a quarter of the smaller one, is
/// not let into the other one. The time t of their first touch is worked out by conservative advancement: with n and d the direction and
/// length of the shortest way to a convex shape and v the velocity relative to it, the plane across that way parts the two until
///
///     t <- t + d / (v . n)        v . n <= 0: they never meet
///
/// From then on the body moves along that plane, where it may meet the next shape, to the end of the step:
///
///     v <- v - ((v - v_other) . n) n        separation = sum of t v over the parts of the step - dt v_end
///
/// Its velocity stays, and contact, which the smaller core leaves room for, changes it in the next step. What is lost is the rest of the
/// step along n: way, less than |v| dt, and what gravity g would do to the velocity meanwhile, which a force takes back,
///
///     f = -m (g . n) n (dt - t) / dt,       v_end = v_0 + dt (g + f / m),
///
/// else a ball would gain energy at every bounce. What bounces in this step (bounce.h) flies as it will leave. A body that is no sphere is taken for the largest sphere about its middle that is as thick as it. Of two
/// such bodies the first one stops, and the second one sees it where it is then.
/// Assumes: the other one moves with the velocity of its point that is below the body's middle; contact forces of this step, which are
/// not known yet, bend the way by less than the core's distance from the surface.
/// Source: Mirtich, Impulse-based Dynamic Simulation of Rigid Body Systems, 1996, sec. 2.3 (conservative advancement); the core:
/// Catto, Continuous Collision, Game Developers Conference 2013; the way back: the project's own.
#pragma once

#include <optional>
#include <span>

#include "murosimf/model/shape.h"

namespace murosimf::collision {

struct MovingEntity;
struct PairSet;
class StaticCompound;

/// The first touch of a moving sphere and a shape.
struct FirstTouch {
  double time = 0;  ///< [s]
  Vec3d normal;     ///< [1] unit, from the sphere to the shape
};

/// Of a sphere that moves with `velocity` [m/s], relative to the shape, within `dt` [s]. Nothing if they do not touch, or part. If they are in
/// each other already, it is now, and the normal that of the shortest way out.
[[nodiscard]] std::optional<FirstTouch> first_touch(const Vec3d& center, double radius, const Vec3d& velocity,
                                                    const Shape& shape, const Transformd& at, double dt);

/// Adds to `separation` of the fast ones; after contacts of the step have been found.
/// `set`: its contacts; gravity [m/s^2], world frame.
void stop_at_touch(std::span<MovingEntity> moving_entities, const PairSet& set, const StaticCompound& environment,
                   const Vec3d& gravity, double dt) noexcept;

}  // namespace murosimf::collision
