// Triangles of a polygon cover it and nothing else: their areas add up to its own, and each lies in it.
#include "murosimf/render/polygon_triangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "murosimf/math/mat3.h"
#include "murosimf/math/random.h"

namespace murosimf::render {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// Gauss's formula, in the plane z = 0; positive if it is counterclockwise.
double area(const std::vector<Vec3d>& p) {
  double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec3d &a = p[i], &b = p[(i + 1) % p.size()];
    sum += 0.5 * (a.x * b.y - b.x * a.y);
  }
  return sum;
}

/// Winding number by angles: another way than the turns of ear clipping.
bool is_in(const std::vector<Vec3d>& p, const Vec3d& q) {
  double around = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec3d a = p[i] - q, b = p[(i + 1) % p.size()] - q;
    around += std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
  }
  return std::abs(around) > 3;
}

double size_of(const std::vector<Vec3d>& p, const Triangles& triangles) {
  double sum = 0;
  for (const auto& [a, b, c] : triangles) sum += 0.5 * norm(cross(p[b] - p[a], p[c] - p[a]));
  return sum;
}

void expect_covered(const std::vector<Vec3d>& p) {
  const Triangles triangles = polygon_triangles(p);
  EXPECT_EQ(triangles.size(), p.size() - 2);
  EXPECT_NEAR(size_of(p, triangles), std::abs(area(p)), 1e-12);  // rounding of sums of order 1
  for (const auto& [a, b, c] : triangles) {
    for (const double share : {1.0 / 3, 0.98, 0.01}) {  // the middle, and near a corner and the opposite side
      EXPECT_TRUE(is_in(p, share * p[a] + 0.5 * (1 - share) * (p[b] + p[c]))) << a << " " << b << " " << c;
    }
    EXPECT_GT(area(p) * area({p[a], p[b], p[c]}), 0) << "in the polygon's order";
  }
}

const std::vector<Vec3d> l_shape{{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0}, {1, 2.5, 0}, {0, 2.5, 0}};

TEST(PolygonTriangles, CoverAnLFromEachOfItsCornersInBothDirections) {
  std::vector<Vec3d> p = l_shape;
  EXPECT_DOUBLE_EQ(area(p), 4.5);
  for (std::size_t i = 0; i < p.size(); ++i) {
    expect_covered(p);
    expect_covered({p.rbegin(), p.rend()});
    std::rotate(p.begin(), p.begin() + 1, p.end());
  }
}

// Stars with random radii and mostly concave corners, and combs, which have few ears.
TEST(PolygonTriangles, CoverAnySimplePolygon) {
  const RandomStream random(1, "stars");
  for (std::uint64_t star = 0; star < 200; ++star) {
    std::vector<Vec3d> p;
    const auto corners = 4 + star % 40;
    for (std::uint64_t i = 0; i < corners; ++i) {
      const double angle = 2 * pi * static_cast<double>(i) / static_cast<double>(corners);
      p.push_back(random.uniform(100 * star + i, 0.1, 1) * Vec3d{std::cos(angle), std::sin(angle), 0});
    }
    expect_covered(p);
  }
  std::vector<Vec3d> comb{{8, -0.5, 0}, {0, -0.5, 0}};
  for (int i = 0; i < 8; ++i) {
    comb.push_back({static_cast<double>(i), 1, 0});
    comb.push_back({i + 0.7, -0.1 - 0.01 * i, 0});
  }
  expect_covered(comb);
}

TEST(PolygonTriangles, StandInAnyPlane) {
  const RandomStream random(2, "planes");
  for (std::uint64_t i = 0; i < 50; ++i) {
    const Mat3d turn = rotation_z(random.uniform(3 * i, 0, 7)) * rotation_x(random.uniform(3 * i + 1, 0, 7)) *
                       rotation_y(random.uniform(3 * i + 2, 0, 7));
    std::vector<Vec3d> p;
    for (const Vec3d& corner : l_shape) p.push_back(Vec3d{1, -2, 0.5} + turn * corner);
    EXPECT_EQ(polygon_triangles(p).size(), 4U);
    EXPECT_NEAR(size_of(p, polygon_triangles(p)), 4.5, 1e-12);
    EXPECT_FALSE(is_convex(p));
  }
}

TEST(PolygonTriangles, CornersInALineAndTwiceAtOnePlaceAddNothing) {
  const std::vector<Vec3d> line{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}};
  EXPECT_DOUBLE_EQ(size_of(line, polygon_triangles(line)), 4);
  EXPECT_TRUE(is_convex(line));
  EXPECT_TRUE(polygon_triangles(std::vector<Vec3d>{{0, 0, 0}, {1, 0, 0}}).empty());
  EXPECT_TRUE(polygon_triangles(std::vector<Vec3d>(7)).empty());
  EXPECT_TRUE(polygon_triangles({}).empty());
}

// Rule: the triangulation of every drawing ends.
TEST(PolygonTriangles, ABorderThatCrossesItselfEnds) {
  const RandomStream random(3, "knots");
  for (std::uint64_t knot = 0; knot < 200; ++knot) {
    std::vector<Vec3d> p;
    for (std::uint64_t i = 0; i < 3 + knot % 30; ++i) {
      const auto coordinate = [&](std::uint64_t k) { return random.uniform(1000 * knot + 3 * i + k, -1, 1); };
      p.push_back({coordinate(0), coordinate(1), coordinate(2)});
    }
    EXPECT_LE(polygon_triangles(p).size(), p.size() - 2);
  }
  const double nan = std::nan("");
  EXPECT_LE(polygon_triangles(std::vector<Vec3d>(5, {nan, nan, nan})).size(), 3U);
}

}  // namespace
}  // namespace murosimf::render
