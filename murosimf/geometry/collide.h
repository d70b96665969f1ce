/// collide.h - exact test of two shapes for overlap.
#pragma once

#include "murosimf/geometry/manifold.h"
#include "murosimf/model/shape.h"

namespace murosimf::geometry {

/// Where A and B overlap: the direction in which the least shift of A parts them, how far, and the points that carry a
/// flat side. False, and `found` unchanged, if they do not overlap. Two planes never do. The order of the two does not
/// matter but for the sign of the normal.
[[nodiscard]] bool collide(const Shape& a, const Transformd& at_a, const Shape& b, const Transformd& at_b,
                           Manifold& found);

}  // namespace murosimf::geometry
