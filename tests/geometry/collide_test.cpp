#include "murosimf/geometry/collide.h"

#include <gtest/gtest.h>

#include "tests/geometry/pairs.h"
#include "tests/law.h"

namespace murosimf::geometry {
namespace {

using namespace pairs;
using fixtures::difference;
using fixtures::outside;

/// All kinds, and a plane where asked for.
std::vector<Shape> kinds_and_plane() {
  std::vector<Shape> shapes = all_kinds();
  shapes.push_back(Plane{});
  return shapes;
}

std::string pair_name(const Shape& a, const Shape& b) { return std::string(shape_name(a)) + '-' + shape_name(b); }

/// Calls visit(a, at_a, b, at_b) with random poses of every ordered pair of kinds, about half of which overlap.
template <class Visit>
void for_pairs(const char* name, int poses, const Visit& visit) {
  const std::vector<Shape> shapes = kinds_and_plane();
  for (const Shape& a : shapes) {
    for (const Shape& b : shapes) {
      if (std::holds_alternative<Plane>(a) && std::holds_alternative<Plane>(b)) continue;
      Dice dice(pair_name(a, b) + name);
      for (int i = 0; i < poses; ++i) {
        const Transformd at_a = random_pose(dice, 0.14), at_b = random_pose(dice, 0.14);
        visit(a, at_a, b, at_b);
      }
    }
  }
}

void expect_pairs(const std::string& law, const std::string& source, const law::Measured& error, double limit) {
  law::expect_below({.law = law, .level = "collision of all pairs of shapes", .source = source}, error, limit, "m");
}

/// Of a plane only one direction counts, which the search by samples would not find.
double least_shift(const Shape& a, const Transformd& at_a, const Shape& b, const Transformd& at_b) {
  if (std::holds_alternative<Plane>(a)) return shift(a, at_a, b, at_b, -at_a.orientation.z);
  if (std::holds_alternative<Plane>(b)) return shift(a, at_a, b, at_b, at_b.orientation.z);
  return LeastShift(a, at_a, b, at_b).value();
}

// Law: a shift by the depth along the normal parts the two, and no shorter shift in any other direction does. Tolerance:
// the demanded 1e-6 m; samples never find a shorter shift than there is.
TEST(Collide, DepthIsTheLeastShift) {
  law::Worst longer, along;
  int touching = 0, apart = 0;
  for_pairs("depth", 40, [&](const Shape& a, const Transformd& at_a, const Shape& b, const Transformd& at_b) {
    const double least = least_shift(a, at_a, b, at_b);
    Manifold found;
    const bool touch = collide(a, at_a, b, at_b, found);
    if (std::abs(least) > 1e-7) {
      ASSERT_EQ(touch, least > 0) << pair_name(a, b) << ' ' << least;
    }
    ++(touch ? touching : apart);
    if (!touch) return;
    double deepest = 0;
    for (int i = 0; i < found.count; ++i) deepest = std::fmax(deepest, found.points[i].depth);
    longer.see(deepest - least, pair_name(a, b));
    along.see(std::abs(shift(a, at_a, b, at_b, found.normal) - deepest), pair_name(a, b));
    EXPECT_NEAR(norm(found.normal), 1, 1e-12);
  });
  EXPECT_GT(touching, 500);
  EXPECT_GT(apart, 500);
  expect_pairs("depth of an overlap: how much shorter a shift in another direction parts the two", "dense samples",
               longer, 1e-6);
  expect_pairs("depth of an overlap: error of the shift along the normal", "support functions", along, 1e-6);
}

// Law: half a depth along the normal from a point is the surface of B, half a depth against it that of A: neither is
// outside. Tolerance: faces may lean by 2.5 degrees against the normal, which shifts points sideways.
TEST(Collide, PointsLieInTheMiddleOfTheOverlap) {
  law::Worst outside_a, outside_b;
  for_pairs("points", 200, [&](const Shape& a, const Transformd& at_a, const Shape& b, const Transformd& at_b) {
    Manifold found;
    if (!collide(a, at_a, b, at_b, found)) return;
    ASSERT_GT(found.count, 0);
    ASSERT_LE(found.count, Manifold::most_points);
    for (int i = 0; i < found.count; ++i) {
      const ManifoldPoint& p = found.points[i];
      EXPECT_GT(p.depth, 0);
      const Vec3d half = 0.5 * p.depth * found.normal;
      outside_a.see(outside(a, to_shape(at_a, p.point - half)), pair_name(a, b));
      outside_b.see(outside(b, to_shape(at_b, p.point + half)), pair_name(a, b));
      for (int k = 0; k < i; ++k) EXPECT_NE(found.points[k].feature, p.feature) << pair_name(a, b);
    }
  });
  expect_pairs("points of an overlap: how far outside of A, half a depth against the normal", "A's surface", outside_a,
               1e-4);
  expect_pairs("points of an overlap: how far outside of B, half a depth along the normal", "B's surface", outside_b,
               1e-4);
}

// Law: the order of A and B has no effect except on the sign of the normal.
TEST(Collide, SwappedPairsGiveTheSame) {
  for_pairs("swap", 100, [&](const Shape& a, const Transformd& at_a, const Shape& b, const Transformd& at_b) {
    Manifold one, other;
    ASSERT_EQ(collide(a, at_a, b, at_b, one), collide(b, at_b, a, at_a, other)) << pair_name(a, b);
    ASSERT_EQ(one.count, other.count) << pair_name(a, b);
    if (one.count == 0) return;
    EXPECT_EQ(difference(one.normal, -other.normal), 0) << pair_name(a, b);
    for (int i = 0; i < one.count; ++i) {
      EXPECT_EQ(difference(one.points[i].point, other.points[i].point), 0) << pair_name(a, b);
      EXPECT_EQ(one.points[i].depth, other.points[i].depth) << pair_name(a, b);
      EXPECT_EQ(one.points[i].feature, other.points[i].feature) << pair_name(a, b);
    }
  });
}

}  // namespace
}  // namespace murosimf::geometry
