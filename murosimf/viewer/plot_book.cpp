#include "murosimf/viewer/plot_book.h"

#include <algorithm>
#include <cmath>

#include "murosimf/math/assert.h"

namespace murosimf::viewer {

/// A value of an earlier instant replaces what was after it: the run has jumped back.
void Curve::add(double time, double value) {
  const auto later = std::ranges::lower_bound(times_, time);
  values_.resize(static_cast<std::size_t>(later - times_.begin()));
  times_.erase(later, times_.end());
  times_.push_back(time);
  values_.push_back(value);
  MUROSIMF_ASSERT(times_.size() == values_.size());
  if (times_.size() > most_) thin_out();
}

void Curve::thin_out() {
  // only the older half: recent samples keep their full rate
  std::size_t kept = 0;
  for (std::size_t i = 0; i < times_.size(); ++i) {
    if (i < times_.size() / 2 && i % 2 == 1) continue;
    times_[kept] = times_[i];
    values_[kept++] = values_[i];
  }
  times_.resize(kept);
  values_.resize(kept);
}

/// Values that are not finite have no place in a range.
Curve::Range Curve::range(double begin) const {
  Range range{INFINITY, -INFINITY};
  for (auto i = static_cast<std::size_t>(std::ranges::lower_bound(times_, begin) - times_.begin()); i < values_.size();
       ++i) {
    if (!std::isfinite(values_[i])) continue;
    range.low = std::min(range.low, values_[i]);
    range.high = std::max(range.high, values_[i]);
  }
  return range.low <= range.high ? range : Range{};
}

void Plot::add(double time, const std::vector<double>& numbers) {
  curves.resize(numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) curves[i].add(time, numbers[i]);
}

std::vector<double> ticks(double low, double high, int count) {
  std::vector<double> places;
  if (!(high > low) || count < 1) return places;
  const double rough = (high - low) / count, power = std::pow(10.0, std::floor(std::log10(rough)));
  double step = 10 * power;
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= rough) {
      step = factor * power;
      break;
    }
  }
  // tolerance: rounding must not drop a tick at an end
  for (double i = std::ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; ++i)
    places.push_back(i == 0 ? 0 : i * step);
  return places;
}

}  // namespace murosimf::viewer
