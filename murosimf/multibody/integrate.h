/// integrate.h - one step of a free body: semi-implicit Euler with the linear velocity in world axes.
///
///     v += dt a       r += dt v         w += dt alpha      Q = exp(dt w) Q
///
/// The linear velocity is advanced in the world frame, never in the body's: a rolling ball advanced in its own frame
/// gains w^2 dt/2 of its speed per second. Source: Featherstone 2008, ch. 2 (rates of quaternions); exponential map
/// instead of the quaternion's rate, so that its length does not drift.
#pragma once

#include "murosimf/math/quaternion.h"
#include "murosimf/math/spatial.h"

namespace murosimf::multibody {

template <class S>
struct FreeBody {
  Vec3<S> position;    ///< [m] world, of the point that is integrated: center of mass, or origin of a base
  Vec3<S> velocity;    ///< [m/s] world, of the same point
  Quaternion<S> turn;  ///< body axes to world axes
  Vec3<S> rate;        ///< [rad/s] angular velocity, world axes
};

/// Advances `body` by dt [s] under `acceleration` = [alpha; a], world axes, of the same point.
template <class S>
void advance(FreeBody<S>& body, const Twist<S>& acceleration, double dt) noexcept;

}  // namespace murosimf::multibody
