// Between which distances a sensor sees: what is shown outside, and that something must be between them.
#include "murosimf/sensors/range.h"

#include <gtest/gtest.h>

#include "tests/fixtures.h"

namespace murosimf::sensors {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(SensorRange, DistancesAreShownWithinTheRange) {
  const Range range{0.5, 4};
  EXPECT_EQ(range.shown(0.5), 0.5);
  EXPECT_EQ(range.shown(4), 4);
  EXPECT_EQ(range.shown(2), 2);
  EXPECT_EQ(range.shown(0.49), -infinity);
  EXPECT_EQ(range.shown(4.01), infinity);
  EXPECT_EQ(range.shown(infinity), infinity);
}

TEST(SensorRange, HasSomethingBetween) {
  EXPECT_EQ(checked(Range{}).max, infinity) << "unlimited by default";
  EXPECT_EQ(checked(Range{0.06, 30}).min, 0.06);
  EXPECT_EQ(fixtures::error_of([] {
              (void)checked(Range{4, 4});
            }),
            "range_min is 4 and range_max 4: nothing is between them");
}

}  // namespace
}  // namespace murosimf::sensors
