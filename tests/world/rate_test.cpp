// Instants without drift, each in the step that begins nearest.
#include "murosimf/world/rate.h"

#include <cstdlib>
#include <vector>

#include <gtest/gtest.h>

namespace murosimf {
namespace {

using namespace std::chrono_literals;

/// Steps, counted from 0, that `rate` falls on.
std::vector<std::int64_t> steps_of(const Rate& rate, Duration step, std::int64_t from, std::int64_t to) {
  std::vector<std::int64_t> steps;
  for (std::int64_t i = from; i < to; ++i) {
    if (rate.falls_on(i * step, step)) steps.push_back(i);
  }
  return steps;
}

// Rule: every instant falls on one step, and none lies nearer.
TEST(Rate, EveryInstantFallsOnItsNearestStep) {
  for (const Rate& rate :
       {Rate(30), Rate(30, 0.25), Rate(59.94), Rate(333), Rate(1000), Rate(1000, 0.5), Rate(999.9)}) {
    for (const Duration step : {Duration(1ms), Duration(800us), Duration(333333)}) {
      const auto steps = steps_of(rate, step, 0, 20000);
      ASSERT_GT(steps.size(), 100U);
      for (std::size_t n = 0; n < steps.size(); ++n) {
        const Duration late = steps[n] * step - rate.instant(static_cast<std::int64_t>(n));
        ASSERT_LE(2 * std::abs(late.count()), step.count())
            << rate.hz << " Hz, phase " << rate.phase << ", number " << n;
      }
    }
  }
}

// Ten days of 30 Hz at 1 ms: 25,920,000 instants, the last ones as near as the first ones. A period in whole nanoseconds would be
// 8.6 ms late by then.
TEST(Rate, DoesNotDrift) {
  const std::int64_t ten_days = 864'000'000;  // steps
  EXPECT_EQ(steps_of(30, 1ms, ten_days, ten_days + 101),
            (std::vector<std::int64_t>{ten_days, ten_days + 33, ten_days + 67, ten_days + 100}));
}

TEST(Rate, OfTwoStepsThatAreEquallyNearTheLaterOneIsIt) {
  EXPECT_EQ(steps_of(Rate(400), 1ms, 0, 10), (std::vector<std::int64_t>{0, 3, 5, 8}));
  EXPECT_EQ(steps_of(Rate(1000, 0.5), 1ms, 0, 4), (std::vector<std::int64_t>{1, 2, 3}));
}

TEST(Rate, ANumberIsARateThatBeginsAtOnce) {
  const Rate rate = 100;
  EXPECT_EQ(rate.instant(0), 0ms);
  EXPECT_EQ(rate.instant(3), 30ms);
  EXPECT_EQ(Rate(100, 0.25).instant(3), 32500us);
  EXPECT_EQ(rate.period(), 10ms);
}

}  // namespace
}  // namespace murosimf
