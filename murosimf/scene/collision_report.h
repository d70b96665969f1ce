/// collision_report.h - cost of collision detection in a scene: tests per step, and time.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace murosimf::scene {

/// Number of steps by their number of tests.
struct TestHistogram {
  std::int64_t bin = 1;             ///< width: 1, 2 or 5 times a power of ten, chosen so that there are at most 20
  std::vector<std::int64_t> steps;  ///< by bin, from 0 tests on
};

/// `tests` of each step.
[[nodiscard]] TestHistogram histogram_of(const std::vector<std::int64_t>& tests);

struct CollisionReport {
  static constexpr int bins = 20;

  std::string scene;
  int robots = 0;
  std::int64_t steps = 0;
  std::int64_t naive_tests = 0;  ///< every shape against every other, and against field and ground
  double mean_volume_tests = 0, mean_object_tests = 0;
  double mean_volume_tests_anew = 0;              ///< without reuse of neighbors from the previous step
  TestHistogram volume_tests_anew, object_tests;  ///< the paper's Fig. 13
  double worst_share = 0;                         ///< of the naive tests, in a step
  std::array<std::int64_t, bins> histogram{};     ///< steps by their share of the naive tests, in bins of 5 %
  double mean_contacts = 0;                       ///< points
  double pairs_us = 0;                            ///< per step: all transforms and tests among robots and ball, median
  double ground_us = 0;                           ///< per step: the same with goals and ground, median
  double detection_us = 0;                        ///< per step: all transforms and tests, median
  double step_us = 0;                             ///< the whole simulation, mean

  [[nodiscard]] double mean_share() const {
    return (mean_volume_tests + mean_object_tests) / static_cast<double>(naive_tests);
  }
  [[nodiscard]] double mean_share_anew() const {
    return (mean_volume_tests_anew + mean_object_tests) / static_cast<double>(naive_tests);
  }
};

/// A table, and histograms of the first report.
[[nodiscard]] std::string to_text(const std::vector<CollisionReport>& reports);

/// One JSON object: scenes [{scene, robots, steps, naive_tests, mean_volume_tests, mean_object_tests, mean_share,
/// worst_share, histogram [], mean_volume_tests_anew, mean_share_anew, volume_tests_anew {bin, steps []}, object_tests {..},
/// mean_contacts, pairs_us, ground_us, step_us}].
[[nodiscard]] std::string to_json(const std::vector<CollisionReport>& reports);

}  // namespace murosimf::scene
