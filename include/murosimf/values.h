/// values.h - the plain values of the interface.
#pragma once

#include "murosimf/version.h"

namespace murosimf {
inline namespace v0 {

struct Vector3 {
  double x = 0, y = 0, z = 0;
  friend bool operator==(const Vector3&, const Vector3&) = default;
};

/// A unit quaternion, w first.
struct Rotation {
  double w = 1, x = 0, y = 0, z = 0;
  friend bool operator==(const Rotation&, const Rotation&) = default;
};

/// Of a frame in another one; `orientation` rotates its axes to those of the other one.
struct Pose {
  Vector3 position;  ///< [m]
  Rotation orientation;
  friend bool operator==(const Pose&, const Pose&) = default;
};

struct Velocity {
  Vector3 linear;   ///< [m/s] of the origin
  Vector3 angular;  ///< [rad/s]
  friend bool operator==(const Velocity&, const Velocity&) = default;
};

}  // namespace v0
}  // namespace murosimf
