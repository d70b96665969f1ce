// Which of many spheres overlap: the same as testing each pair, in any crowd, and with fewer tests.
#include "murosimf/geometry/sweep_and_prune.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "murosimf/geometry/volume_overlap.h"
#include "tests/fixtures.h"

namespace murosimf::geometry {
namespace {

using fixtures::Dice;
using Pairs = std::vector<SweepAndPrune::Pair>;
using Spheres = std::vector<BoundingSphere>;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

Pairs by_force(const Spheres& spheres) {
  Pairs pairs;
  for (int i = 0; i < static_cast<int>(spheres.size()); ++i) {
    for (int j = i + 1; j < static_cast<int>(spheres.size()); ++j) {
      if (overlap(spheres[i], spheres[j])) pairs.emplace_back(i, j);
    }
  }
  return pairs;
}

/// Spheres of unequal sizes in a box of the given half sizes [m].
Spheres crowd(Dice& dice, int count, const Vec3d& half) {
  Spheres spheres;
  for (int i = 0; i < count; ++i) {
    const Vec3d place{dice.uniform(-half.x, half.x), dice.uniform(-half.y, half.y), dice.uniform(-half.z, half.z)};
    spheres.push_back({place, dice.uniform(0, 0.4) * dice.uniform(0, 1)});
  }
  return spheres;
}

// Law: what testing each pair finds, in its order, for crowds along each axis and with one memory for all of them.
TEST(SweepAndPrune, FindsWhatAllPairsFind) {
  Dice dice("crowds");
  SweepAndPrune sweep;
  std::size_t found = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vec3d half{dice.uniform(0, 2), dice.uniform(0, 2), i % 3 ? 0.1 : dice.uniform(0, 3)};
    const Spheres spheres = crowd(dice, dice.pick(40), half);
    const Pairs expected = by_force(spheres);
    ASSERT_EQ(sweep.find(spheres), expected) << i;
    ASSERT_EQ(sweep.pairs(), expected);
    found += expected.size();
  }
  EXPECT_GT(found, 10000U);
}

// Law: the same while bodies move a little or jump, grow and go bad: nothing of earlier calls is left, but its order.
TEST(SweepAndPrune, FollowsMotion) {
  Dice dice("motion");
  Spheres spheres = crowd(dice, 30, {2, 1, 0.3});
  SweepAndPrune sweep;
  for (int step = 0; step < 2000; ++step) {
    for (BoundingSphere& sphere : spheres) sphere.center = sphere.center + dice.vector(0.02);
    BoundingSphere& one = spheres[static_cast<std::size_t>(dice.pick(30))];
    if (step % 10 == 0) one.center = dice.vector(3);
    if (step % 50 == 7) one.center.y = no_number;
    if (step % 50 == 8) one = {dice.vector(1), 0.3};
    if (step % 70 == 9) one.radius = infinity;
    if (step % 70 == 10) one.radius = 0.2;
    ASSERT_EQ(sweep.find(spheres), by_force(spheres)) << step;
    SweepAndPrune forgetful;
    forgetful.find(spheres);
    ASSERT_EQ(sweep.tests(), forgetful.tests()) << step;
  }
}

// Law: numbers of any size, infinite ones and NaN do not affect other spheres.
TEST(SweepAndPrune, AnyNumberIsAllowed) {
  const double numbers[] = {0,     -0.0,  1,      -1,    1e-170, 3e-162,    1e-300,   1e80,
                            -2e80, 1e149, -3e150, 7e155, 1e300,  -infinity, infinity, no_number};
  Dice dice("numbers");
  const auto number = [&] { return dice.pick(3) ? dice.uniform(-1, 1) : numbers[dice.pick(16)]; };
  SweepAndPrune sweep;
  std::size_t found = 0;
  for (int i = 0; i < 5000; ++i) {
    Spheres spheres;
    for (int k = 0; k < 12; ++k) spheres.push_back({{number(), number(), number()}, number()});
    const Pairs expected = by_force(spheres);
    ASSERT_EQ(sweep.find(spheres), expected) << i;
    found += expected.size();
  }
  EXPECT_GT(found, 10000U);
}

// Law: spheres that touch in one point, after rounding, on an axis of any kind and far from the origin.
TEST(SweepAndPrune, TouchingIsNotLostByRounding) {
  Dice dice("touching");
  SweepAndPrune sweep;
  int touching = 0;
  for (int i = 0; i < 20000; ++i) {
    const double a = dice.uniform(0, 1), b = dice.uniform(0, 1), far = std::pow(10, dice.uniform(-3, 6));
    Vec3d way;
    (i % 3 == 0 ? way.x : i % 3 == 1 ? way.y : way.z) = a + b;
    const Vec3d at = far * dice.vector(1);
    const Spheres spheres{{at + way, a}, {at, b}};
    const Pairs expected = by_force(spheres);
    ASSERT_EQ(sweep.find(spheres), expected) << i;
    touching += static_cast<int>(expected.size());
  }
  EXPECT_GT(touching, 5000);
  EXPECT_LT(touching, 19000);
}

// A row along each axis: neighbors only are tested, and a distant one does not change that.
TEST(SweepAndPrune, TestsGrowWithNeighborsOnly) {
  for (int axis = 0; axis < 3; ++axis) {
    Spheres spheres;
    for (int i = 0; i < 200; ++i) {
      const double along = 1.0 * ((i * 77) % 200);
      spheres.push_back({{axis == 0 ? along : 0.1, axis == 1 ? along : 0.2, axis == 2 ? along : 0.3}, 0.6});
    }
    spheres[17].center = {axis == 0 ? 0.0 : 1e6, axis == 0 ? 1e6 : 0.0, 0};
    SweepAndPrune sweep;
    EXPECT_EQ(sweep.find(spheres).size(), 197U) << axis;
    EXPECT_LT(sweep.tests(), 420) << axis;
    EXPECT_EQ(sweep.pairs(), by_force(spheres));
  }
}

TEST(SweepAndPrune, NobodyAndOneAlone) {
  SweepAndPrune sweep;
  EXPECT_TRUE(sweep.find({}).empty());
  EXPECT_TRUE(sweep.find(Spheres{{{1, 2, 3}, 4}}).empty());
  EXPECT_EQ(sweep.tests(), 0);
  EXPECT_EQ(sweep.find(Spheres{{{1, 2, 3}, 4}, {{1, 2, 9}, 3}}), (Pairs{{0, 1}}));
  EXPECT_TRUE(sweep.find({}).empty());
}

}  // namespace
}  // namespace murosimf::geometry
