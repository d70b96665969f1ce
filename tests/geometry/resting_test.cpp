// What rests on what: enough points, well spread, that keep their names.
#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "murosimf/geometry/collide.h"
#include "tests/geometry/pairs.h"

namespace murosimf::geometry {
namespace {

using namespace pairs;

constexpr double sink = 1e-3;

struct Resting {
  const char* name;
  Shape shape, below;
  Transformd at;  // just touching what is below, which is at the origin
  int least_points;
  double spread;  // [m] that the points must be apart from each other at most
};

double widest(const Manifold& found) {
  double square = 0;
  for (int i = 0; i < found.count; ++i) {
    for (int k = 0; k < i; ++k) square = std::fmax(square, norm(found.points[i].point - found.points[k].point));
  }
  return square;
}

/// Area [m^2] seen from above that is not surpassed by three points of the manifold.
double largest_triangle(const Manifold& found) {
  double area = 0;
  for (int i = 0; i < found.count; ++i) {
    for (int j = 0; j < i; ++j) {
      for (int k = 0; k < j; ++k) {
        const Vec3d &p = found.points[i].point, &q = found.points[j].point, &r = found.points[k].point;
        area = std::fmax(area, 0.5 * norm(cross(q - p, r - p)));
      }
    }
  }
  return area;
}

const Box table{{0.5, 0.5, 0.1}};

std::vector<Resting> resting_cases() {
  const Mat3d lying = rotation_y(pi / 2);
  const Mat3d turned = rotation_z(0.3);
  const Shape box = Box{{0.05, 0.1, 0.03}}, cylinder = Cylinder{0.06, 0.1}, capsule = Capsule{0.04, 0.1};
  const Shape hexagon = prism(6, 0.08, 0.05), round = prism(40, 0.08, 0.05);
  return {
      {"box on plane", box, Plane{}, {{0, 0, 0.03}, turned}, 4, 0.2},
      {"box on box", box, table, {{0.1, 0, 0.13}, turned}, 4, 0.2},
      {"staggered boxes", box, table, {{0.5, 0.1, 0.13}, turned}, 4, 0.15},
      {"boxes crossed", Box{{0.3, 0.02, 0.02}}, Box{{0.02, 0.3, 0.1}}, {{0, 0, 0.12}, {}}, 4, 0.05},
      {"box edge down", box, table, {{0, 0, 0.1 + 0.08 / std::sqrt(2.0)}, rotation_y(pi / 4)}, 2, 0.2},
      {"capsule on plane", capsule, Plane{}, {{0, 0, 0.04}, lying}, 2, 0.2},
      {"capsule on box", capsule, table, {{0, 0, 0.14}, turned * lying}, 2, 0.2},
      {"capsule over the edge of a box", capsule, table, {{0.5, 0, 0.14}, turned * lying}, 2, 0.09},
      {"capsule on capsule", capsule, Capsule{0.05, 0.3}, {{0.09, 0, 0.05}, {}}, 2, 0.199},
      {"capsule along the edge of a box",
       capsule,
       Box{{0.1, 0.1, 0.1}},
       {{0.1 + 0.04 / std::sqrt(2.0), 0, 0.1 + 0.04 / std::sqrt(2.0)}, rotation_x(pi / 2)},
       2,
       0.19},
      {"cylinder stands on plane", cylinder, Plane{}, {{0, 0, 0.1}, turned}, 3, 0.11},
      {"cylinder stands on box", cylinder, table, {{0, 0, 0.2}, turned}, 3, 0.11},
      {"cylinder stands over the edge of a box", cylinder, table, {{0.5, 0, 0.2}, turned}, 3, 0.11},
      {"cylinder stands on cylinder", cylinder, Cylinder{0.05, 0.1}, {{0.025, 0.005, 0.2}, turned}, 3, 0.08},
      {"cylinder lies on plane", cylinder, Plane{}, {{0, 0, 0.06}, lying}, 2, 0.2},
      {"cylinder lies on box", cylinder, table, {{0, 0, 0.16}, turned * lying}, 2, 0.2},
      {"cylinder lies on cylinder, parallel", cylinder, Cylinder{0.05, 0.2}, {{0.11, 0, 0}, {}}, 2, 0.2},
      {"box on standing cylinder", box, cylinder, {{0, 0, 0.13}, turned}, 3, 0.1},
      {"capsule on cylinder cap", capsule, cylinder, {{0, 0.01, 0.14}, lying}, 2, 0.1},
      {"hexagon on plane", hexagon, Plane{}, {{0, 0, 0.05}, turned}, 6, 0.15},
      {"hexagon on box", hexagon, table, {{0, 0, 0.15}, turned}, 6, 0.15},
      {"hexagon on its side", hexagon, table, {{0, 0, 0.1 + 0.08 * std::cos(pi / 6)}, rotation_x(pi / 2)}, 4, 0.1},
      {"hexagon on hexagon", hexagon, prism(6, 0.06, 0.1), {{0.01, 0, 0.15}, turned}, 5, 0.1},
      {"polygon of 40 corners on box", round, table, {{0, 0, 0.15}, turned}, 8, 0.15},
      {"polygon of 40 corners on plane", round, Plane{}, {{0, 0, 0.05}, turned}, 8, 0.15},
      {"octahedron on a face",
       octahedron(0.1, 0.1, 0.1),
       table,
       {{0, 0, 0.1 + 0.1 / std::sqrt(3.0)}, rotation_y(std::acos(1 / std::sqrt(3.0))) * rotation_z(-pi / 4)},
       3,
       0.13},
      {"ellipsoid on box", Ellipsoid{{0.05, 0.09, 0.14}}, table, {{0, 0, 0.24}, turned}, 1, 0},
      {"sphere on box", Sphere{0.1}, table, {{0, 0, 0.2}, {}}, 1, 0},
  };
}

// Rule: a flat side rests on three points or more, a line on two, far enough from each other to stand on; all are as deep
// as it was pressed in.
TEST(Resting, HasEnoughPointsFarApart) {
  for (const Resting& it : resting_cases()) {
    // pressed in along the exact normal
    Transformd at = it.at;
    Manifold found;
    at.position = (1 - 1e-6) * at.position;
    ASSERT_TRUE(collide(it.shape, at, it.below, {}, found)) << it.name;
    at.position = it.at.position - sink * found.normal;
    ASSERT_TRUE(collide(it.shape, at, it.below, {}, found)) << it.name;
    EXPECT_GE(found.count, it.least_points) << it.name;
    EXPECT_GE(widest(found), it.spread) << it.name;
    if (it.least_points > 2) {
      EXPECT_GT(largest_triangle(found), 0.1 * it.spread * it.spread) << it.name;
    }
    for (int i = 0; i < found.count; ++i) EXPECT_NEAR(found.points[i].depth, sink, 1e-9) << it.name << ' ' << i;
  }
}

std::set<std::uint32_t> names(const Manifold& found) {
  std::set<std::uint32_t> all;
  for (int i = 0; i < found.count; ++i) all.insert(found.points[i].feature);
  return all;
}

// Rule: while it slides slowly and rocks a little, pressed in so deep that no corner lifts, what meets stays the same and
// so do its names; no point jumps. Over a polygon in a rim the exact deepest point may replace a corner: 22 degrees of it.
TEST(Resting, KeepsNamesWhileItSlidesAndRocks) {
  for (const Resting& it : resting_cases()) {
    std::set<std::uint32_t> first;
    for (int step = 0; step < 400; ++step) {
      const double t = 0.05 * step;
      const Vec3d rock{1e-3 * std::sin(3 * t), 1e-3 * std::sin(2.3 * t + 1), 1e-3 * std::sin(t)};
      Transformd at = it.at;
      at.position = it.at.position + 1e-4 * Vec3d{std::sin(t), std::cos(1.7 * t), 0};
      at.orientation = to_matrix(exponential(rock)) * at.orientation;
      Manifold found;
      ASSERT_TRUE(collide(it.shape, {it.at.position, it.at.orientation}, it.below, {{0, 0, 1e-6}, {}}, found) ||
                  collide(it.shape, {it.at.position, it.at.orientation}, it.below, {{1e-6, 0, 0}, {}}, found))
          << it.name;
      at.position -= sink * found.normal;
      ASSERT_TRUE(collide(it.shape, at, it.below, {}, found)) << it.name;
      if (step == 0) first = names(found);
      EXPECT_EQ(names(found), first) << it.name << " in step " << step;
      if (names(found) != first) break;
    }
  }
}

}  // namespace
}  // namespace murosimf::geometry
