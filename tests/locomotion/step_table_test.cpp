// The steady walk as a table: least squares return the numbers of the samples, and the course between bins is linear.
#include "murosimf/locomotion/step_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace murosimf::locomotion {
namespace {

/// A table of numbers that are all different.
StepCourse some_course(double scale) {
  StepCourse course{};
  double number = 0.01;
  for (auto& bin : course) {
    for (auto& signal : bin) {
      for (double& factor : signal) factor = scale * (number = std::fmod(1.7 * number + 0.31, 1.0));
    }
  }
  return course;
}

/// In the middle of a bin.
double middle(std::size_t bin) { return (static_cast<double>(bin) + 0.5) / step_bins; }

TEST(StepTable, IsLinearBetweenTheMiddlesOfItsBins) {
  const StepTable table{some_course(1), some_course(1)};
  const Vec3d v{0.3, -0.1, 0.7};
  const auto a = steady_signals(table, 0, middle(4), v).numbers(), b = steady_signals(table, 0, middle(5), v).numbers();
  const auto c = steady_signals(table, 0, 0.25 * middle(4) + 0.75 * middle(5), v).numbers();
  for (std::size_t k = 0; k < step_signals; ++k) {
    const auto& f = table.rigid[4][k];
    EXPECT_NEAR(a[k], f[0] + f[1] * v.x + f[2] * v.y + f[3] * v.z, 1e-14);
    EXPECT_NEAR(c[k], 0.25 * a[k] + 0.75 * b[k], 1e-13);
  }
  EXPECT_EQ(steady_signals(table, 0, 0, v).numbers(), steady_signals(table, 0, middle(0), v).numbers());
  EXPECT_EQ(steady_signals(table, 0, 1, v).numbers(), steady_signals(table, 0, middle(step_bins - 1), v).numbers());
}

TEST(StepTable, GoesFromRigidToCompliant) {
  const StepTable table{some_course(1), some_course(3)};
  const Vec3d v{0.1, 0, 0};
  const auto rigid = steady_signals(table, 0, 0.3, v).numbers();
  const auto half = steady_signals(table, 0.5, 0.3, v).numbers();
  for (std::size_t k = 0; k < step_signals; ++k) EXPECT_NEAR(half[k], 2 * rigid[k], 1e-13);
}

TEST(StepTable, IsFoundAgainFromItsSamples) {
  const StepTable table{some_course(1), {}};
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> speed(-1, 1);
  std::vector<StepSample> samples;
  for (std::size_t bin = 0; bin < step_bins; ++bin) {
    for (int i = 0; i < 400; ++i) {
      const Vec3d v{speed(random), speed(random), speed(random)};
      samples.push_back({middle(bin), v, steady_signals(table, 0, middle(bin), v)});
    }
  }
  const StepCourse found = fit_course(samples);
  for (std::size_t bin = 0; bin < step_bins; ++bin) {
    for (std::size_t k = 0; k < step_signals; ++k) {
      for (std::size_t n = 0; n < step_terms; ++n) {
        // the weight 1e-3 on the diagonal against sums of squares of 400/3 and more
        EXPECT_NEAR(found[bin][k][n], table.rigid[bin][k][n], 3e-5) << bin << ", " << k << ", " << n;
      }
    }
  }
}

TEST(StepTable, TakesTheNeighboursOfBinsWithoutSamples) {
  StepSample sample{.share = middle(10), .velocity = {}, .signals = {.forward = 0.5}};
  const StepCourse course = fit_course(std::vector(50, sample));
  EXPECT_NEAR(course[0][0][0], 0.5, 1e-4);
  EXPECT_NEAR(course[23][0][0], 0.5, 1e-4);
  EXPECT_EQ(fit_course({})[0][0][0], 0);
}

}  // namespace
}  // namespace murosimf::locomotion
