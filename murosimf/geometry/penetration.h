/// penetration.h - the least shift that parts two convex bodies, found by their support functions.
#pragma once

#include "murosimf/geometry/build_manifold.h"
#include "murosimf/geometry/support.h"

namespace murosimf::geometry {

/// The least shift, and the two surface points that it brings together.
struct Deepest {
  Penetration penetration;
  Vec3d on_a, on_b;  ///< [m] world frame; on_b - on_a = depth * normal
};

/// False if the two are apart.
[[nodiscard]] bool find_deepest(const Body& a, const Body& b, Deepest& deepest);

}  // namespace murosimf::geometry
