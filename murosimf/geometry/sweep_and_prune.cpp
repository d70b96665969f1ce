#include "murosimf/geometry/sweep_and_prune.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "murosimf/geometry/volume_overlap.h"
#include "murosimf/math/insertion_sort.h"

namespace murosimf::geometry {
namespace {

constexpr double enormous = 1e150;        // [m] its square is still a number
constexpr double rounding = 1e-14;        // [1] of the numbers that an interval is made of
constexpr double invisible = 1e-150;      // [m] the square of less is 0
constexpr std::size_t most_samples = 64;  // to find out how far centers are spread

double component(const Vec3d& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

/// How far [m] the middle half of some centers reaches.
double spread(std::span<const BoundingSphere> spheres, int axis, std::vector<double>& centers) {
  centers.clear();
  const std::size_t stride = 1 + spheres.size() / most_samples;
  for (std::size_t i = 0; i < spheres.size(); i += stride) {
    if (is_bounded(spheres[i])) centers.push_back(component(spheres[i].center, axis));
  }
  if (centers.empty()) return 0;
  std::sort(centers.begin(), centers.end());
  return centers[3 * centers.size() / 4] - centers[centers.size() / 4];
}

/// The axis on which centers are spread most.
int widest_axis(std::span<const BoundingSphere> spheres, std::vector<double>& centers) {
  const std::array width{spread(spheres, 0, centers), spread(spheres, 1, centers), spread(spheres, 2, centers)};
  return static_cast<int>(std::max_element(width.begin(), width.end()) - width.begin());
}

}  // namespace

bool is_bounded(const BoundingSphere& sphere) {
  const Vec3d c = componentwise_abs(sphere.center);
  return c.x + c.y + c.z + abs(sphere.radius) < enormous;
}

const std::vector<SweepAndPrune::Pair>& SweepAndPrune::find(std::span<const BoundingSphere> spheres) {
  found_.clear();
  tests_ = 0;
  if (spheres.size() < 2) {  // one robot alone: nothing to sort
    count_ = 0;
    pairs_.clear();
    return pairs_;
  }
  sort_intervals(spheres);
  sweep(spheres);
  test_unbounded(spheres);
  sort_pairs(spheres.size());
  return pairs_;
}

/// The intervals of the last call are kept in their order if they are those of the same spheres on the same axis.
void SweepAndPrune::sort_intervals(std::span<const BoundingSphere> spheres) {
  const int axis = widest_axis(spheres, centers_);
  before_.swap(unbounded_);
  unbounded_.clear();
  for (int i = 0; i < static_cast<int>(spheres.size()); ++i) {
    if (!is_bounded(spheres[i])) unbounded_.push_back(i);
  }
  const bool same = axis == axis_ && spheres.size() == count_ && unbounded_ == before_;
  axis_ = axis;
  count_ = spheres.size();
  const auto earlier = [](const Interval& a, const Interval& b) {
    return a.low != b.low ? a.low < b.low : a.sphere < b.sphere;
  };
  if (same) {
    for (Interval& one : intervals_) one = interval(spheres[one.sphere], one.sphere);
    insertion_sort(intervals_.begin(), intervals_.end(), earlier);
    return;
  }
  intervals_.clear();
  for (int i = 0; i < static_cast<int>(spheres.size()); ++i) {
    if (is_bounded(spheres[i])) intervals_.push_back(interval(spheres[i], i));
  }
  std::sort(intervals_.begin(), intervals_.end(), earlier);
}

/// A little longer than the sphere: what overlaps after rounding has intervals that do.
SweepAndPrune::Interval SweepAndPrune::interval(const BoundingSphere& sphere, int number) const {
  const double middle = component(sphere.center, axis_), radius = abs(sphere.radius);
  const double reach = radius + rounding * (abs(middle) + radius) + invisible;
  return {middle - reach, middle + reach, number};
}

void SweepAndPrune::sweep(std::span<const BoundingSphere> spheres) {
  for (auto one = intervals_.begin(); one != intervals_.end(); ++one) {
    for (auto other = one + 1; other != intervals_.end(); ++other) {
      ++tests_;
      if (other->low > one->high) break;
      if (overlap(spheres[one->sphere], spheres[other->sphere])) {
        found_.push_back(std::minmax(one->sphere, other->sphere));
      }
    }
  }
}

void SweepAndPrune::test_unbounded(std::span<const BoundingSphere> spheres) {
  for (const int one : unbounded_) {
    for (int other = 0; other < static_cast<int>(spheres.size()); ++other) {
      if (other == one || (other < one && !is_bounded(spheres[other]))) continue;  // each pair once
      ++tests_;
      if (overlap(spheres[one], spheres[other])) found_.push_back(std::minmax(one, other));
    }
  }
}

/// By the smaller number into rows, then each row by itself: they are short.
void SweepAndPrune::sort_pairs(std::size_t spheres) {
  begin_.assign(spheres + 1, 0);
  for (const Pair& pair : found_) ++begin_[static_cast<std::size_t>(pair.first) + 1];
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  pairs_.resize(found_.size());
  for (const Pair& pair : found_) pairs_[begin_[pair.first]++] = pair;  // ends where the next one begins
  auto row = pairs_.begin();
  for (std::size_t i = 0; i < spheres; ++i) {
    const auto end = pairs_.begin() + static_cast<std::ptrdiff_t>(begin_[i]);
    std::sort(row, end);
    row = end;
  }
}

}  // namespace murosimf::geometry
