/// line_distance_field.h - distance from any place of a field to the nearest line, from a table.
///
/// Source: likelihood fields, Thrun, Burgard, Fox, Probabilistic Robotics (2005), ch. 6.4.
#pragma once

#include <vector>

#include "murosimf/math/vec3.h"
#include "murosimf/model/shape.h"

namespace murosimf::soccer {

class LineDistanceField {
 public:
  /// Distances from the middles of the lines, a cell every `cell` [m]; beyond the ground of the markings the nearest cell
  /// is used. Throws SetupError if the markings have no lines, or more than 4 million cells.
  explicit LineDistanceField(const Markings& markings, double cell = 0.02);

  /// [m] from (x, y); with an error of up to 0.7 cells.
  [[nodiscard]] double distance(double x, double y) const noexcept;

 private:
  double cell_, half_length_, half_width_;  // [m]
  int columns_, rows_;
  std::vector<float> distances_;  // [m] row by row
};

/// [m] from (x, y) to the middle of the nearest stroke; infinite if there is none.
[[nodiscard]] double distance_to_lines(const Markings& markings, double x, double y) noexcept;

}  // namespace murosimf::soccer
