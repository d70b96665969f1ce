/// four_points.h - four points of a manifold that carry what all of it would.
#pragma once

#include "murosimf/geometry/manifold.h"

namespace murosimf::geometry {

/// Leaves at most four points, in the order that they had: the first, the farthest from it, and the farthest from the
/// line through both on either side; and the deepest, in place of the nearest of these, if none of them is about as
/// deep. Points that are about equally far count in their order, so that the choice stays the same while a body rocks.
void keep_four(Manifold& manifold) noexcept;

}  // namespace murosimf::geometry
