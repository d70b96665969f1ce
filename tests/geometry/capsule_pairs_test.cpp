// Unequal capsules: the one point where they cross lies in the middle of their overlap, as deep in one as in the other.
#include <gtest/gtest.h>

#include "murosimf/geometry/collide.h"
#include "tests/geometry/pairs.h"

namespace murosimf::geometry {
namespace {

using namespace pairs;

TEST(CapsulePairs, PointOfCrossingCapsulesIsInTheMiddleOfTheirOverlap) {
  const Capsule thick{0.09, 0.2}, thin{0.02, 0.35};
  for (const bool thick_first : {true, false}) {
    const Capsule &a = thick_first ? thick : thin, &b = thick_first ? thin : thick;
    // axes cross at 70 degrees, 0.1 m apart: 10 mm of overlap, away from the middles
    const Transformd at_a{{0.05, 0.02, 0.1}, rotation_y(pi / 2)}, at_b{{0, 0, 0}, rotation_z(1.2) * rotation_y(pi / 2)};
    Manifold found;
    ASSERT_TRUE(collide(a, at_a, b, at_b, found));
    ASSERT_EQ(found.count, 1);
    EXPECT_NEAR(found.points[0].depth, 0.01, 1e-12);
    EXPECT_LT(fixtures::difference(found.normal, {0, 0, 1}), 1e-12);
    const Vec3d& point = found.points[0].point;
    EXPECT_NEAR(fixtures::outside(a, transposed_times(at_a.orientation, point - at_a.position)), -0.005, 1e-12);
    EXPECT_NEAR(fixtures::outside(b, transposed_times(at_b.orientation, point - at_b.position)), -0.005, 1e-12);
    EXPECT_NEAR(point.z, (thick_first ? 0.02 : 0.09) - 0.005, 1e-12);
  }
}

// Side by side, also of unequal length: two points as far apart as both go, in the middle of the overlap.
TEST(CapsulePairs, PointsOfParallelCapsulesAreInTheMiddleOfTheirOverlap) {
  const Capsule a{0.09, 0.2}, b{0.02, 0.35};
  const Transformd at_a{{0.05, 0, 0.1}, rotation_y(pi / 2)}, at_b{{0, 0, 0}, rotation_y(pi / 2)};
  Manifold found;
  ASSERT_TRUE(collide(a, at_a, b, at_b, found));
  ASSERT_EQ(found.count, 2);
  EXPECT_NEAR(std::abs(found.points[0].point.x - found.points[1].point.x), 0.4, 1e-9);
  for (int k = 0; k < 2; ++k) {
    EXPECT_NEAR(found.points[k].depth, 0.01, 1e-12);
    EXPECT_NEAR(found.points[k].point.z, 0.015, 1e-12);
  }
}

}  // namespace
}  // namespace murosimf::geometry
