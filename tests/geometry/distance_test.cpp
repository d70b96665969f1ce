#include "murosimf/geometry/distance.h"

#include <gtest/gtest.h>

#include "murosimf/geometry/collide.h"
#include "tests/geometry/pairs.h"
#include "tests/law.h"

namespace murosimf::geometry {
namespace {

using namespace pairs;
using fixtures::difference;
using fixtures::outside;

void expect_distance(const std::string& law, const std::string& source, const law::Measured& error, double limit) {
  law::expect_below({.law = law, .level = "distance of all pairs of shapes", .source = source}, error, limit, "m");
}

// Law: of two shapes that are apart, the distance is the width of the widest gap between two parallel planes that part
// them, and the distance of two points of their surfaces. So points that lie on both, and a gap of the same width upright
// on their line, prove each other. Tolerance: rounding for the
// lengths; the direction of the gap is good to 1e-7, which counts at faces and edges.
TEST(Distance, PointsAndPartingPlanesProveEachOther) {
  law::Worst gap_error, length_error, surface_error;
  int apart = 0;
  Dice dice("distance");
  for (const Shape& a : all_kinds()) {
    for (const Shape& b : all_kinds()) {
      for (int i = 0; i < 200; ++i) {
        const Transformd at_a = random_pose(dice, 0.4), at_b = random_pose(dice, 0.4);
        const Gap gap = distance(a, at_a, b, at_b);
        if (gap.distance < 1e-3) continue;
        ++apart;
        const std::string name = std::string(shape_name(a)) + '-' + shape_name(b);
        const Vec3d n = unit(gap.on_a - gap.on_b);
        gap_error.see(std::abs(gap.distance + shift(a, at_a, b, at_b, n)), name);
        length_error.see(std::abs(gap.distance - norm(gap.on_a - gap.on_b)), name);
        surface_error.see(std::fmax(std::abs(outside(a, to_shape(at_a, gap.on_a))), 0), name);
        surface_error.see(std::fmax(std::abs(outside(b, to_shape(at_b, gap.on_b))), 0), name);
      }
    }
  }
  EXPECT_GT(apart, 4000);
  expect_distance("distance: error of the gap between parallel planes", "support functions", gap_error, 1e-8);
  expect_distance("distance: error of the length between the closest points", "same distance", length_error, 1e-14);
  expect_distance("distance: how far the closest points are off the surfaces", "they lie on them", surface_error,
                  1e-11);
}

// Law: overlapping shapes have the depth as a negative distance, between points of either surface.
TEST(Distance, OfAnOverlapIsItsDepth) {
  Dice dice("negative distance");
  int overlapping = 0;
  for (const Shape& a : all_kinds()) {
    for (const Shape& b : all_kinds()) {
      for (int i = 0; i < 30; ++i) {
        const Transformd at_a = random_pose(dice, 0.08), at_b = random_pose(dice, 0.08);
        Manifold found;
        const Gap gap = distance(a, at_a, b, at_b);
        ASSERT_EQ(collide(a, at_a, b, at_b, found), gap.distance < 0);
        if (gap.distance >= 0) continue;
        ++overlapping;
        EXPECT_NEAR(shift(a, at_a, b, at_b, found.normal), -gap.distance, 1e-7);
        EXPECT_LT(difference(gap.on_b - gap.on_a, -gap.distance * found.normal), 1e-12);
      }
    }
  }
  EXPECT_GT(overlapping, 500);
}

// Law: by hand. Tolerance: rounding.
TEST(Distance, ByHand) {
  const Transformd here{}, there{{0, 0, 3}, {}}, lying{{0, 3, 0}, rotation_x(pi / 2)};
  EXPECT_NEAR(distance(Sphere{1}, here, Sphere{0.5}, there).distance, 1.5, 1e-15);
  EXPECT_NEAR(distance(Box{{1, 1, 1}}, here, Cylinder{0.5, 0.25}, there).distance, 1.75, 1e-14);
  EXPECT_NEAR(distance(Capsule{0.5, 1}, here, Capsule{0.25, 1}, lying).distance, 3 - 1 - 0.25 - 0.5, 1e-14);
  EXPECT_NEAR(distance(Ellipsoid{{1, 1, 2}}, here, Box{{1, 1, 0.25}}, there).distance, 0.75, 1e-12);
  EXPECT_NEAR(distance(octahedron(1, 1, 1), here, octahedron(1, 1, 1), there).distance, 1, 1e-14);
  EXPECT_NEAR(distance(Plane{}, here, Box{{1, 1, 0.5}}, there).distance, 2.5, 1e-15);
  EXPECT_NEAR(distance(Box{{1, 1, 0.5}}, {{0, 0, 0.2}, {}}, Plane{}, here).distance, -0.3, 1e-15);
  EXPECT_TRUE(std::isinf(distance(Plane{}, here, Plane{}, there).distance));
}

// Law: closest points of corners: two boxes whose corners face each other along the diagonal.
TEST(Distance, CornerToCorner) {
  const Gap gap = distance(Box{{1, 1, 1}}, {}, Box{{1, 1, 1}}, {{3, 3, 3}, {}});
  EXPECT_NEAR(gap.distance, std::sqrt(3.0), 1e-14);
  EXPECT_LT(difference(gap.on_a, {1, 1, 1}), 1e-14);
  EXPECT_LT(difference(gap.on_b, {2, 2, 2}), 1e-14);
}

}  // namespace
}  // namespace murosimf::geometry
