/// sweep_and_prune.h - which of many spheres overlap, without testing each pair.
///
/// Spheres become intervals on one axis, sorted by where they begin; only those whose intervals overlap are tested. The axis
/// is the one on which the middle half of the centers is spread most, so that a few distant ones have no influence. Since
/// bodies move little from step to step, the order of the step before needs few changes: n bodies on a field cost little
/// more than n times one.
/// Source: Cohen, Lin, Manocha and Ponamgi, "I-COLLIDE", Symposium on Interactive 3D Graphics 1995; one axis here.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "murosimf/geometry/volume.h"

namespace murosimf::geometry {

/// False for spheres of infinite or enormous size or place, and for those that are not made of numbers.
[[nodiscard]] bool is_bounded(const BoundingSphere& sphere);

class SweepAndPrune {
 public:
  /// Two spheres by their numbers, the smaller one first.
  using Pair = std::pair<int, int>;

  /// All pairs that overlap (volume_overlap.h), exactly those that testing each pair would find, sorted. They do not depend
  /// on earlier calls, nor does the number of pairs that were tested. Spheres of infinite or enormous size or place are
  /// tested with all others; one whose place is not a number overlaps none.
  const std::vector<Pair>& find(std::span<const BoundingSphere> spheres);
  /// What was found last.
  [[nodiscard]] const std::vector<Pair>& pairs() const { return pairs_; }
  /// How many pairs were tested for it, on the axis or as spheres.
  [[nodiscard]] std::int64_t tests() const { return tests_; }

 private:
  /// What a sphere covers on the axis.
  struct Interval {
    double low = 0, high = 0;
    int sphere = 0;
  };
  void sort_intervals(std::span<const BoundingSphere> spheres);
  [[nodiscard]] Interval interval(const BoundingSphere& sphere, int number) const;
  void sweep(std::span<const BoundingSphere> spheres);
  void test_unbounded(std::span<const BoundingSphere> spheres);
  void sort_pairs(std::size_t spheres);

  std::vector<Interval> intervals_;  // those of the last call, in their order
  std::vector<int> unbounded_;       // spheres without an interval, rising
  std::vector<int> before_;          // the same of the call before; working memory
  std::vector<Pair> found_;          // in the order of the sweep
  std::vector<Pair> pairs_;
  std::vector<std::size_t> begin_;  // by smaller number: where its pairs begin; working memory
  std::vector<double> centers_;     // working memory
  std::size_t count_ = 0;           // of spheres
  int axis_ = 0;
  std::int64_t tests_ = 0;
};

}  // namespace murosimf::geometry
