#include "murosimf/geometry/four_points.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "tests/fixtures.h"

namespace murosimf::geometry {
namespace {

using fixtures::Dice;

/// A regular polygon of radius 1 in the plane across a direction, turned by `phase` [rad].
Manifold polygon(int sides, const Mat3d& R, double phase) {
  Manifold manifold;
  manifold.normal = R.z;
  for (int i = 0; i < sides; ++i) {
    const double angle = phase + 2 * pi * i / sides;
    manifold.points[manifold.count++] = {std::cos(angle) * R.x + std::sin(angle) * R.y, 1e-3,
                                         static_cast<std::uint32_t>(10 + i)};
  }
  return manifold;
}

/// Area [m^2] of a convex polygon whose corners stand in order, seen along its normal.
double area(const Manifold& m) {
  Vec3d sum;
  for (int i = 0; i < m.count; ++i) sum += cross(m.points[i].point, m.points[(i + 1) % m.count].point);
  return 0.5 * std::fabs(dot(sum, m.normal));
}

/// How far [m] the origin is inside the polygon.
double support_of_middle(const Manifold& m) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < m.count; ++i) {
    const Vec3d p = m.points[i].point, side = m.points[(i + 1) % m.count].point - p;
    least = std::min(least, dot(cross(m.normal, side), -p) / norm(side));
  }
  return least;
}

// Law: what stands on its middle stands on the four as well, in any attitude.
TEST(FourPoints, CarryTheMiddleOfARegularPolygon) {
  Dice dice("polygons");
  for (int sides = 5; sides <= 8; ++sides) {
    for (int i = 0; i < 1000; ++i) {
      Manifold all = polygon(sides, dice.turn(), dice.uniform(0, 6)), few = all;
      keep_four(few);
      ASSERT_EQ(few.count, 4);
      EXPECT_GT(support_of_middle(few), 0.25) << sides;
      EXPECT_GT(area(few), 0.6 * area(all)) << sides;
      for (int k = 1; k < 4; ++k) EXPECT_LT(few.points[k - 1].feature, few.points[k].feature);
    }
  }
}

// Rule: a point that is clearly deeper than all others stays, and does not cost the others' support.
TEST(FourPoints, KeepTheDeepest) {
  for (int deepest = 0; deepest < 8; ++deepest) {
    Manifold few = polygon(8, {}, 0.1);
    few.points[deepest].depth = 2e-3;
    keep_four(few);
    ASSERT_EQ(few.count, 4);
    const auto end = few.points.begin() + few.count;
    EXPECT_TRUE(std::any_of(few.points.begin(), end, [](const ManifoldPoint& p) { return p.depth == 2e-3; }));
    EXPECT_GT(support_of_middle(few), 0.25) << deepest;
  }
}

// Rule: depths that differ as little as on a flat side that rocks change nothing.
TEST(FourPoints, StayTheSameWhileABodyRocks) {
  Dice dice("rocking");
  Manifold still = polygon(8, {}, 0.1);
  keep_four(still);
  for (int i = 0; i < 100; ++i) {
    Manifold rocking = polygon(8, {}, 0.1);
    for (ManifoldPoint& p : rocking.points) p.depth *= dice.uniform(0.98, 1.02);
    keep_four(rocking);
    for (int k = 0; k < 4; ++k) EXPECT_EQ(rocking.points[k].feature, still.points[k].feature);
  }
}

TEST(FourPoints, LeaveFourAlone) {
  for (int sides = 1; sides <= 4; ++sides) {
    Manifold few = polygon(sides, {}, 0.1);
    keep_four(few);
    EXPECT_EQ(few.count, sides);
  }
}

TEST(FourPoints, OfOnePlaceAreOne) {
  Manifold same = polygon(6, {}, 0);
  for (ManifoldPoint& p : same.points) p.point = {1, 2, 3};
  keep_four(same);
  EXPECT_EQ(same.count, 1);
}

}  // namespace
}  // namespace murosimf::geometry
