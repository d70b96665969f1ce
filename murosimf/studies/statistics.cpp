#include "murosimf/studies/statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "murosimf/math/assert.h"

namespace murosimf::studies {

/// Few degrees of freedom from the usual tables, more by the series of Cornish and Fisher, which is good to 5 digits there.
double student_975(std::size_t freedom) {
  constexpr std::array few = {12.7062, 4.30265, 3.18245, 2.77645, 2.57058, 2.44691, 2.36462,
                              2.30600, 2.26216, 2.22814, 2.20099, 2.17881, 2.16037, 2.14479};
  if (freedom == 0) return std::numeric_limits<double>::quiet_NaN();
  if (freedom <= few.size()) return few[freedom - 1];
  const double n = static_cast<double>(freedom), z = 1.959963984540054, z2 = z * z;
  const double first = z * (z2 + 1) / 4, second = z * ((5 * z2 + 16) * z2 + 3) / 96;
  const double third = z * (((3 * z2 + 19) * z2 + 17) * z2 - 15) / 384;
  const double fourth = z * ((((79 * z2 + 776) * z2 + 1482) * z2 - 1920) * z2 - 945) / 92160;
  return z + (first + (second + (third + fourth / n) / n) / n) / n;
}

namespace {

/// Of `n` cases, the share `p` of which was 1: the p' at which the observed share is 1.96 standard deviations away.
void set_wilson(MeanInterval& result) {
  MUROSIMF_ASSERT(result.count >= 2 && result.mean >= 0 && result.mean <= 1);
  constexpr double z = 1.959963984540054, z2 = z * z;
  const double n = static_cast<double>(result.count), p = result.mean, scale = 1 / (1 + z2 / n);
  const double middle = scale * (p + z2 / (2 * n));
  const double half = scale * z * std::sqrt(p * (1 - p) / n + z2 / (4 * n * n));
  result.low = p > 0 ? middle - half : 0;  // without rounding, where no case or every case was 1
  result.high = p < 1 ? middle + half : 1;
}

}  // namespace

MeanInterval mean_interval(const std::vector<double>& values) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  MeanInterval result{.count = 0, .mean = nan, .half = nan, .low = nan, .high = nan};
  bool cases = true, counts = true;
  double first = nan, sum = 0, squares = 0;  // the sum is that of differences to the first: equal values have no spread
  for (const double value : values) {
    if (std::isnan(value)) continue;
    if (result.count++ == 0) first = value;
    sum += value - first;
    cases = cases && (value == 0 || value == 1);
    counts = counts && value >= 0 && value == std::floor(value);
  }
  if (result.count == 0) return result;
  const double n = static_cast<double>(result.count);
  result.mean = first + sum / n;
  if (result.count < 2) return result;
  for (const double value : values) {
    if (!std::isnan(value)) squares += (value - result.mean) * (value - result.mean);
  }
  const double half = student_975(result.count - 1) * std::sqrt(squares / (n - 1) / n);
  result.low = result.mean - half;
  result.high = result.mean + half;
  if (counts) result.low = std::max(0.0, result.low);
  if (cases) set_wilson(result);
  result.half = (result.high - result.low) / 2;
  return result;
}

}  // namespace murosimf::studies
