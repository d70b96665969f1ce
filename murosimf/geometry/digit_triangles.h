/// digit_triangles.h - numbers for shirts, as flat triangles: bold digits with cut corners, as teams wear them.
#pragma once

#include "murosimf/geometry/triangle_mesh.h"

namespace murosimf::geometry {

/// Digits of height 1 and width 0.6, 0.12 apart, in the plane z = 0: x to the right, y up, the middle of the number at the
/// origin. Triangles look along +z; some overlap. Throws SetupError for a negative number.
[[nodiscard]] TriangleMesh digit_triangles(int number);

/// [1] Width of the same.
[[nodiscard]] double number_width(int number);

}  // namespace murosimf::geometry
