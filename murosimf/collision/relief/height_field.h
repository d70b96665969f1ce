/// height_field.h - ground by its heights over a grid.
#pragma once

#include <cstddef>
#include <vector>

#include "murosimf/collision/relief/relief.h"

namespace murosimf::collision {

struct HeightField {
  std::size_t rows = 0, columns = 0;  ///< at least two each
  std::vector<double> heights;   ///< [m] row by row; the first row is at the largest y, each begins at the smallest x
  double length = 0, width = 0;  ///< [m] along x (columns) and y (rows), from the first to the last height
  double base = 0.1;             ///< [m] of the solid below its lowest height
};

/// Two triangles to a cell, which share the diagonal from its corner at small x and y, and walls down around them. The middle of
/// the grid is at x = y = 0, height 0 at z = 0.
[[nodiscard]] ReliefPtr make_relief(const HeightField& field);

}  // namespace murosimf::collision
