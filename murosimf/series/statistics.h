/// statistics.h - the mean of some runs, and how far off it may be.
#pragma once

#include <cstddef>
#include <vector>

namespace murosimf::series {

struct MeanInterval {
  std::size_t count = 0;  ///< of values that are numbers
  double mean = 0;        ///< NaN: there are none
  double half = 0;        ///< the mean of all possible runs is within mean +- half with 95 %; NaN for less than two
};

/// Of values that are independent and nearly normal, by Student's distribution. NaN are left out.
[[nodiscard]] MeanInterval mean_interval(const std::vector<double>& values);

/// What Student's t with so many degrees of freedom stays below with 97.5 %.
[[nodiscard]] double student_975(std::size_t freedom);

}  // namespace murosimf::series
