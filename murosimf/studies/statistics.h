/// statistics.h - the mean of some runs, and how far off it may be.
#pragma once

#include <cstddef>
#include <vector>

namespace murosimf::studies {

struct MeanInterval {
  std::size_t count = 0;     ///< of values that are numbers
  double mean = 0;           ///< NaN: there are none
  double half = 0;           ///< (high - low) / 2
  double low = 0, high = 0;  ///< the mean of all possible runs is between them with 95 %; NaN for less than two values
};

/// Of values that are independent; NaN are left out. Values that are all 0 or 1 are taken for cases of a rate, by Wilson's score interval (Wilson,
/// JASA 22, 1927), which stays within 0 and 1. Others are taken for nearly normal, by Student's distribution; the mean of values that are whole and
/// not negative (counts) is not below 0.
[[nodiscard]] MeanInterval mean_interval(const std::vector<double>& values);

/// What Student's t with so many degrees of freedom stays below with 97.5 %.
[[nodiscard]] double student_975(std::size_t freedom);

}  // namespace murosimf::studies
