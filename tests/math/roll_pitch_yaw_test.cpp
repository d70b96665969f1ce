/// roll_pitch_yaw_test - angles of a matrix turn as it does.
#include "murosimf/math/roll_pitch_yaw.h"

#include <gtest/gtest.h>

#include "murosimf/math/random.h"
#include "tests/fixtures.h"

namespace murosimf {
namespace {

using fixtures::difference;

// Rounding of atan2 and of three products: some 1e-16 each. The inverse is checked by the reader's own product of three turns.
TEST(RollPitchYaw, TurnsAsTheMatrixDoes) {
  RandomStream random(3, "turns");
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const Vec3d rpy{random.uniform(3 * i, -pi, pi), random.uniform(3 * i + 1, -pi, pi),
                    random.uniform(3 * i + 2, -pi, pi)};
    const Mat3d R = from_roll_pitch_yaw(rpy);
    EXPECT_LT(difference(from_roll_pitch_yaw(roll_pitch_yaw(R)), R), 2e-15);
  }
}

// Where roll and yaw are about the same axis, the usual formulas lose half of the digits.
TEST(RollPitchYaw, IsAsExactAtARightAngle) {
  for (const double pitch : {pi / 2, -pi / 2, pi / 2 - 1e-9, pi / 2 - 1e-15}) {
    for (const double roll : {0.0, 0.3, -2.0}) {
      const Mat3d R = from_roll_pitch_yaw({roll, pitch, 0.7});
      EXPECT_LT(difference(from_roll_pitch_yaw(roll_pitch_yaw(R)), R), 2e-15) << pitch << ' ' << roll;
    }
  }
}

// Only the sum of roll and yaw matters there, and files read better with a zero.
TEST(RollPitchYaw, HasNoYawAtARightAngle) {
  const Vec3d rpy = roll_pitch_yaw(from_roll_pitch_yaw({0.3, pi / 2, 0.7}));
  EXPECT_EQ(rpy.z, 0);
  EXPECT_NEAR(rpy.x, -0.4, 1e-15);
}

}  // namespace
}  // namespace murosimf
