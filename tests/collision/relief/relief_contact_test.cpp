// Contacts with triangles that know their neighbors, against distances from all triangles.
#include "murosimf/collision/relief/relief_contact.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include <gtest/gtest.h>

#include "murosimf/collision/relief/height_field.h"
#include "murosimf/geometry/sphere_contact.h"
#include "tests/fixtures.h"

namespace murosimf::collision {
namespace {

using fixtures::Dice;

HeightField field_of(int n, double size, const std::function<double(double, double)>& height) {
  HeightField field{.rows = static_cast<std::size_t>(n),
                    .columns = static_cast<std::size_t>(n),
                    .heights = {},
                    .length = size,
                    .width = size,
                    .base = 0.2};
  const auto at = [&](int k) { return size * (static_cast<double>(k) / (n - 1) - 0.5); };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) field.heights.push_back(height(at(j), -at(i)));
  }
  return field;
}

std::vector<ReliefContact> contacts(const Relief& relief, const Shape& shape, const Transformd& at,
                                    const Transformd& at_relief = {}) {
  std::vector<ReliefContact> found;
  std::vector<int> all(relief.triangles().size());
  std::iota(all.begin(), all.end(), 0);
  find_relief_contacts(shape, at, relief, at_relief, all, found);
  return found;
}

/// [m] From a point to the nearest of all prisms, by the closest points of polyhedra: another way than that of contacts.
double distance_to(const Shapes& prisms, const Vec3d& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const PlacedShape& prism : prisms) {
    constexpr double reach = 10;
    const auto contact =
        geometry::sphere_contact(transposed_times(prism.orientation, p - prism.position), reach, prism.shape);
    if (contact) least = std::min(least, reach - contact->depth);
  }
  return least;
}

TEST(ReliefContactOf, SpheresAreAsDeepAsTheNearestPointIsNear) {
  Dice dice("rough");
  const auto relief = make_relief(field_of(9, 0.8, [&](double, double) { return dice.uniform(0, 0.1); }));
  // its walls are the sides of the prisms beside them
  Shapes prisms;
  for (std::size_t i = 0; i < relief->triangles().size(); ++i) {
    if (relief->triangles()[i].normal.z > 1e-3) prisms.push_back(relief->prisms({}, {})[i]);
  }
  int touching = 0;
  for (int i = 0; i < 500; ++i) {
    const Vec3d center{dice.uniform(-0.5, 0.5), dice.uniform(-0.5, 0.5), dice.uniform(-0.1, 0.2)};
    const double distance = distance_to(prisms, center), radius = dice.uniform(0.02, 0.12);
    if (distance <= 1e-6) continue;  // inside: faces only
    const auto found = contacts(*relief, Sphere{radius}, {center, {}});
    double deepest = 0;
    for (const ReliefContact& c : found) {
      deepest = std::max(deepest, c.depth);
      EXPECT_NEAR(norm(c.normal), 1, 1e-12);
    }
    EXPECT_NEAR(deepest, std::max(0.0, radius - distance), 1e-9) << i;
    touching += deepest > 0;
  }
  EXPECT_GT(touching, 100);
}

TEST(ReliefContactOf, FlatCellsAreOnePlane) {
  const auto relief = make_relief(field_of(11, 1, [](double, double) { return 0.0; }));
  Dice dice("flat");
  for (int i = 0; i < 300; ++i) {
    // every third one right above a corner of the grid, every third one above an edge
    Vec3d center{dice.uniform(-0.3, 0.3), dice.uniform(-0.3, 0.3), 0.045};
    if (i % 3 > 0) center.x = 0.1 * std::round(10 * center.x);
    if (i % 3 > 1) center.y = 0.1 * std::round(10 * center.y);
    const Mat3d turn = rotation_z(dice.uniform(0, 6));
    const auto ball = contacts(*relief, Sphere{0.05}, {center, turn});
    ASSERT_EQ(ball.size(), 1U) << i;
    EXPECT_NEAR(ball[0].depth, 0.005, 1e-12);
    EXPECT_NEAR(ball[0].normal.z, 1, 1e-12);
    const auto box = contacts(*relief, Box{{0.12, 0.07, 0.05}}, {center, turn});
    ASSERT_EQ(box.size(), 4U) << i;
    for (const ReliefContact& c : box) {
      EXPECT_NEAR(c.depth, 0.005, 1e-12);
      EXPECT_NEAR(c.normal.z, 1, 1e-12);
    }
    EXPECT_EQ(contacts(*relief, Capsule{0.05, 0.1}, {center, turn * rotation_y(pi / 2)}).size(), 2U) << i;
  }
}

/// A roof, its ridge along y.
ReliefPtr roof(double slope) {
  return make_relief(field_of(3, 2, [&](double x, double) { return -slope * std::abs(x); }));
}

TEST(ReliefContactOf, ARidgeCarriesABoxThatLiesOnIt) {
  const auto found = contacts(*roof(0.3), Box{{0.2, 0.1, 0.05}}, {{0.05, 0.03, 0.049}, {}});
  ASSERT_GE(found.size(), 2U);
  for (const ReliefContact& c : found) {
    EXPECT_NEAR(c.normal.z, 1, 1e-9);
    EXPECT_NEAR(c.depth, 0.001, 1e-9);
    EXPECT_NEAR(c.point.x, 0, 1e-9);
  }
  const auto [low, high] = std::ranges::minmax(found, {}, [](const ReliefContact& c) { return c.point.y; });
  EXPECT_NEAR(low.point.y, -0.07, 1e-3);
  EXPECT_NEAR(high.point.y, 0.13, 1e-3);
}

TEST(ReliefContactOf, ARidgeCarriesACapsuleAcrossIt) {
  const auto found = contacts(*roof(0.3), Capsule{0.05, 0.3}, {{0.05, 0.03, 0.049}, rotation_y(pi / 2)});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].normal.z, 1, 1e-9);
  EXPECT_NEAR(found[0].depth, 0.001, 1e-9);
  EXPECT_NEAR(found[0].point.y, 0.03, 1e-9);
}

TEST(ReliefContactOf, AValleyHoldsABallByBothSides) {
  const auto found = contacts(*roof(-0.5), Sphere{0.1}, {{0, 0.03, 0.11}, {}});
  ASSERT_EQ(found.size(), 2U);
  for (const ReliefContact& c : found) EXPECT_NEAR(std::abs(c.normal.x), 0.5 / std::sqrt(1.25), 1e-12);
  EXPECT_NE(found[0].feature, found[1].feature);
}

TEST(ReliefContactOf, APeakCarriesABox) {
  const auto peak = make_relief(field_of(3, 0.4, [](double x, double y) { return x == 0 && y == 0 ? 0.1 : 0.0; }));
  const auto found = contacts(*peak, Box{{0.05, 0.06, 0.02}}, {{0.01, 0.005, 0.119}, {}});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].normal.z, 1, 1e-9);
  EXPECT_NEAR(found[0].depth, 0.001, 1e-9);
}

TEST(ReliefContactOf, ItsPlaceInTheWorldTurnsEverything) {
  Dice dice("turned");
  const auto relief = make_relief(field_of(5, 0.8, [&](double, double) { return dice.uniform(0, 0.1); }));
  const Shape box = Box{{0.1, 0.07, 0.05}};
  const Transformd at{{0.02, 0.03, 0.08}, dice.turn()}, world{{1, 2, 3}, dice.turn()};
  const auto here = contacts(*relief, box, at), there = contacts(*relief, box, world * at, world);
  ASSERT_EQ(here.size(), there.size());
  ASSERT_FALSE(here.empty());
  for (std::size_t i = 0; i < here.size(); ++i) {
    EXPECT_EQ(here[i].feature, there[i].feature);
    EXPECT_NEAR(here[i].depth, there[i].depth, 1e-9);
    EXPECT_LT(norm(world.orientation * here[i].normal - there[i].normal), 1e-9);
    EXPECT_LT(norm(world.position + world.orientation * here[i].point - there[i].point), 1e-9);
  }
}

// A closed box of 3 mm of which both sides are triangles: no prism stands out of the other side.
TEST(ReliefOf, AThinPlateIsNoThickerThanItIs) {
  geometry::TriangleMesh plate;
  for (const double z : {-0.0015, 0.0015}) {
    for (const double x : {-1.0, 1.0}) {
      for (const double y : {-1.0, 1.0}) plate.vertices.push_back({x, y, z});
    }
  }
  plate.triangles = {{4, 6, 5}, {5, 6, 7}, {0, 1, 2}, {1, 3, 2}, {0, 4, 1}, {1, 4, 5},
                     {2, 3, 6}, {3, 7, 6}, {0, 2, 4}, {2, 6, 4}, {1, 5, 3}, {3, 5, 7}};
  const Relief relief(plate, {.thickness = 0.1, .bottom = {}});
  for (const PlacedShape& prism : relief.prisms({}, {})) {
    for (const Vec3d& v : std::get<Convex>(prism.shape).hull->vertices)
      EXPECT_LE(std::abs((prism.position + v).z), 0.0015 + 1e-9);
  }
}

}  // namespace
}  // namespace murosimf::collision
