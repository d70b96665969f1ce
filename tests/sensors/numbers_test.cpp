// Numbers that only one type of sensor has: within their bounds, ends included; else the key is named.
#include "murosimf/sensors/numbers.h"

#include <gtest/gtest.h>

#include "murosimf/model/error.h"
#include "tests/fixtures.h"

namespace murosimf::sensors {
namespace {

using fixtures::error_of;
using fixtures::says;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double none = std::numeric_limits<double>::quiet_NaN();

SensorSpec with(const std::string& key, double number) { return {.numbers = {{key, number}}}; }

TEST(SensorNumbers, WhatIsNotSaidIsTheDefault) {
  const SensorSpec spec = with("gain", 7);
  EXPECT_EQ(checked_number(spec, "size", 3, {1, 5}), 3);
  EXPECT_EQ(checked_positive(spec, "size", 2.5), 2.5);
  EXPECT_EQ(checked_count(spec, "size", 4, {1, 5}), 4);
  EXPECT_EQ(checked_fov(spec, "size", 1.5), 1.5);
  EXPECT_EQ(checked_number(spec, "gain", 3), 7);
}

TEST(SensorNumbers, EndsBelongToTheBounds) {
  for (const double good : {-1.5, 0.0, 4.0}) EXPECT_EQ(checked_number(with("gain", good), "gain", 0, {-1.5, 4}), good);
  for (const double bad : {-1.6, 4.1, none, infinity, -infinity}) {
    const std::string error = error_of([&] { (void)checked_number(with("gain", bad), "gain", 0, {-1.5, 4}); });
    EXPECT_TRUE(says(error, {"gain is", "it must be from -1.5 to 4"})) << bad;
  }
  EXPECT_EQ(error_of([] { (void)checked_number(with("gain", -1), "gain", 0); }), "gain is -1; it must be from 0 on");
  EXPECT_EQ(checked_number(with("gain", infinity), "gain", 0), infinity) << "without an upper end";
}

TEST(SensorNumbers, PositiveOnesAreFiniteToo) {
  EXPECT_EQ(checked_positive(with("gain", 1e-9), "gain", 1), 1e-9);
  for (const double bad : {0.0, -1.0, infinity, none}) {
    EXPECT_TRUE(says(error_of([&] { (void)checked_positive(with("gain", bad), "gain", 1); }),
                     {"gain is", "it must be positive"}))
        << bad;
  }
}

TEST(SensorNumbers, CountsAreWhole) {
  EXPECT_EQ(checked_count(with("rays", 5), "rays", 1, {1, 5}), 5);
  EXPECT_EQ(error_of([] {
              (void)checked_count(with("rays", 2.5), "rays", 1, {1, 5});
            }),
            "rays is 2.5; it must be a whole number");
  EXPECT_TRUE(says(error_of([] { (void)checked_count(with("rays", 6), "rays", 1, {1, 5}); }), {"rays is 6"}));
}

// Rule: 3.1416 to both sides is meant as all round.
TEST(SensorNumbers, RoundedAnglesCountAsAllRound) {
  EXPECT_EQ(checked_fov(with("fov", 6.2832), "fov", 1), 2 * pi);
  EXPECT_EQ(checked_fov(with("fov", 3.1416), "fov", 1, pi), pi);
  EXPECT_EQ(checked_fov(with("fov", 0.3), "fov", 1), 0.3);
  EXPECT_TRUE(says(error_of([] { (void)checked_fov(with("fov", 6.2833), "fov", 1); }), {"fov is 6.2833"}));
  EXPECT_TRUE(says(error_of([] { (void)checked_fov(with("fov", 3.1417), "fov", 1, pi); }), {"fov is 3.1417"}));
}

TEST(SensorNumbers, RangesHaveSomethingBetween) {
  const Range range = checked_range({.numbers = {{"range_min", 0.5}, {"range_max", 4}}}, {});
  EXPECT_EQ(range.min, 0.5);
  EXPECT_EQ(range.max, 4);
  EXPECT_EQ(checked_range({}, {}).min, 0) << "everything, if nobody says anything";
  EXPECT_EQ(checked_range({}, {}).max, infinity);
  const Range usual = checked_range({}, {0.06, 30});
  EXPECT_EQ(usual.min, 0.06);
  EXPECT_EQ(usual.max, 30);
  EXPECT_EQ(error_of([] {
              (void)checked_range({.numbers = {{"range_min", 4}, {"range_max", 4}}}, {});
            }),
            "range_min is 4 and range_max 4: nothing is between them");
  EXPECT_NE(error_of([] { (void)checked_range({.numbers = {{"range_min", -1}}}, {}); }), "no error");
}

TEST(SensorNumbers, DistancesAreShownWithinTheRange) {
  const Range range{0.5, 4};
  EXPECT_EQ(range.shown(0.5), 0.5);
  EXPECT_EQ(range.shown(4), 4);
  EXPECT_EQ(range.shown(2), 2);
  EXPECT_EQ(range.shown(0.49), -infinity);
  EXPECT_EQ(range.shown(4.01), infinity);
  EXPECT_EQ(range.shown(infinity), infinity);
}

}  // namespace
}  // namespace murosimf::sensors
