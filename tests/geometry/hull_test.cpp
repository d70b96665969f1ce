/// hull_test - convex hulls of points against closed forms, Euler's formula and brute force.
#include "murosimf/geometry/hull.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "murosimf/geometry/mesh_mass.h"
#include "tests/fixtures.h"

namespace murosimf::geometry {
namespace {

using fixtures::Dice;
using fixtures::difference;
using fixtures::error_of;
using fixtures::says;

std::vector<Vec3d> box_corners(const Vec3d& half, const Vec3d& middle = {}) {
  std::vector<Vec3d> points;
  for (const double x : {-half.x, half.x}) {
    for (const double y : {-half.y, half.y}) {
      for (const double z : {-half.z, half.z}) points.push_back(middle + Vec3d{x, y, z});
    }
  }
  return points;
}

std::vector<Vec3d> cloud(int count, bool on_sphere) {
  Dice dice("hull cloud");
  std::vector<Vec3d> points;
  for (int i = 0; i < count; ++i) points.push_back(on_sphere ? dice.unit() : dice.vector(1));
  return points;
}

std::size_t edges(const ConvexHull& hull) { return hull.neighbors.size() / 2; }

/// How far `points` stand out of the faces [m]; each point in the frame of the hull.
double sticking_out(const ConvexHull& hull, const std::vector<Vec3d>& points) {
  double worst = -1e300;
  for (std::size_t i = 0; i < hull.faces.size(); ++i) {
    for (const Vec3d& p : points) {
      worst = fixtures::largest(worst, dot(hull.normals[i], p - hull.vertices[hull.faces[i][0]]));
    }
  }
  return worst;
}

/// How far the points reach in a direction [m].
double reach(const std::vector<Vec3d>& points, const Vec3d& direction) {
  double most = -1e300;
  for (const Vec3d& p : points) most = std::max(most, dot(direction, p));
  return most;
}

std::vector<Vec3d> shifted(std::vector<Vec3d> points, const Vec3d& by) {
  for (Vec3d& p : points) p -= by;
  return points;
}

/// Everything that ConvexHull promises about its faces, normals and neighbors.
void expect_proper(const ConvexHull& hull) {
  ASSERT_EQ(hull.normals.size(), hull.faces.size());
  ASSERT_EQ(hull.first_neighbor.size(), hull.vertices.size() + 1);
  EXPECT_EQ(hull.vertices.size() + hull.faces.size(), edges(hull) + 2);  // Euler
  std::set<std::pair<std::uint32_t, std::uint32_t>> from_faces, from_lists;
  for (std::size_t i = 0; i < hull.faces.size(); ++i) {
    const auto& face = hull.faces[i];
    EXPECT_NEAR(norm(hull.normals[i]), 1, 1e-12);
    const auto corner = [&](std::size_t k) { return hull.vertices[face[k % face.size()]]; };
    for (std::size_t k = 0; k < face.size(); ++k) {
      from_faces.emplace(face[k], face[(k + 1) % face.size()]);
      // counterclockwise: every corner turns left about the outward normal
      const Vec3d turn = cross(corner(k + 1) - corner(k), corner(k + 2) - corner(k + 1));
      EXPECT_GT(dot(turn, hull.normals[i]), 0);
    }
    EXPECT_GT(dot(hull.normals[i], corner(0)), 0);  // the origin is inside all hulls of this test
  }
  for (std::uint32_t i = 0; i < hull.vertices.size(); ++i) {
    for (std::uint32_t k = hull.first_neighbor[i]; k < hull.first_neighbor[i + 1]; ++k) {
      from_lists.emplace(i, hull.neighbors[k]);
    }
  }
  EXPECT_EQ(from_faces, from_lists);
}

TEST(Hull, OfABoxHasSixQuadrilateralsWhereverItIs) {
  const Vec3d middle{3, -4, 5};
  auto points = box_corners({0.1, 0.2, 0.3}, middle);
  points.push_back(middle + Vec3d{0.05, 0, 0.3});  // inside a face
  points.push_back(middle + Vec3d{0.1, 0.2, 0});   // on an edge
  points.push_back(points[2]);                     // twice
  const Hull made = make_hull(points);
  EXPECT_LT(norm(made.middle - middle), 1e-15);
  EXPECT_EQ(made.hull.vertices.size(), 8U);
  EXPECT_EQ(made.hull.faces.size(), 6U);
  EXPECT_EQ(edges(made.hull), 12U);
  for (const auto& face : made.hull.faces) EXPECT_EQ(face.size(), 4U);
  expect_proper(made.hull);
}

TEST(Hull, OfAnOctahedronHasEightTriangles) {
  const auto made = make_hull(std::vector<Vec3d>{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}});
  EXPECT_EQ(made.hull.vertices.size(), 6U);
  EXPECT_EQ(made.hull.faces.size(), 8U);
  expect_proper(made.hull);
}

TEST(Hull, EnclosesAllPointsAndConsistsOfThem) {
  for (const bool on_sphere : {false, true}) {
    const auto points = cloud(1000, on_sphere);
    const auto [hull, middle, error] = make_hull(points);
    expect_proper(hull);
    EXPECT_LT(sticking_out(hull, shifted(points, middle)), 1e-12);
    for (const Vec3d& vertex : hull.vertices) {
      EXPECT_TRUE(std::ranges::any_of(points, [&](const Vec3d& p) { return difference(p, vertex + middle) < 1e-15; }));
    }
    if (on_sphere) {
      EXPECT_EQ(hull.vertices.size(), points.size());
    }
  }
}

TEST(Hull, MiddleOfItsBoxIsTheOrigin) {
  const auto hull = make_hull(cloud(100, false)).hull;
  for (double Vec3d::*axis : {&Vec3d::x, &Vec3d::y, &Vec3d::z}) {
    const auto [low, high] = std::ranges::minmax(hull.vertices, {}, axis);
    EXPECT_NEAR(low.*axis, -(high.*axis), 1e-15);
  }
}

TEST(Hull, IsTheSameForPointsInAnyOrderButForTheNumbers) {
  auto points = cloud(200, false);
  const auto first = make_hull(points).hull;
  std::ranges::reverse(points);
  const auto second = make_hull(points).hull;
  EXPECT_EQ(first.faces.size(), second.faces.size());
  ASSERT_EQ(first.vertices.size(), second.vertices.size());
  for (std::size_t i = 0; i < first.vertices.size(); ++i) {
    EXPECT_EQ(difference(first.vertices[i], second.vertices[second.vertices.size() - 1 - i]), 0);
  }
}

TEST(Hull, JoinsPlanesThatSinglePrecisionBroke) {
  Dice dice("rounded planes");
  for (int round = 0; round < 50; ++round) {
    const Mat3d turn = dice.turn();
    std::vector<Vec3d> points;
    // corners and points of the faces, as a binary STL file of a turned box holds them
    for (int i = 0; i < 60; ++i) {
      const Vec3d p{dice.pick(2) - 0.5, dice.pick(4) / 3.0 - 0.5, dice.pick(4) / 3.0 - 0.5};
      const Vec3d q = turn * Vec3d{0.1 * p.x, 0.2 * p.y, 0.3 * p.z};
      points.push_back({static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z)});
    }
    for (const Vec3d& corner : box_corners({0.05, 0.1, 0.15})) {
      const Vec3d q = turn * corner;
      points.push_back({static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z)});
    }
    const auto [hull, middle, error] = make_hull(points);
    EXPECT_EQ(hull.faces.size(), 6U) << "round " << round;
    EXPECT_EQ(hull.vertices.size(), 8U) << "round " << round;
    EXPECT_LT(sticking_out(hull, shifted(points, middle)), 0.15 * 4 * plane_tolerance);
  }
}

TEST(Hull, HasConvexFacesEvenIfPointsAlmostLieInPlanes) {
  Dice dice("noisy box");
  for (int round = 0; round < 500; ++round) {
    const double noise = std::pow(10.0, dice.uniform(-8, -3));
    std::vector<Vec3d> points;
    for (int i = 0; i < 150; ++i) {
      Vec3d p = dice.vector(1);
      double Vec3d::*const axis = std::array{&Vec3d::x, &Vec3d::y, &Vec3d::z}[static_cast<std::size_t>(dice.pick(3))];
      p.*axis = (dice.chance(0.5) ? 1 : -1) + dice.uniform(-noise, noise);
      points.push_back({0.5 * p.x, 0.1 * p.y, p.z});
    }
    const auto [hull, middle, error] = make_hull(points);
    EXPECT_LT(sticking_out(hull, shifted(points, middle)), 10 * plane_tolerance) << "round " << round;
    for (std::size_t i = 0; i < hull.faces.size(); ++i) {
      const auto corner = [&](std::size_t k) { return hull.vertices[hull.faces[i][k % hull.faces[i].size()]]; };
      for (std::size_t k = 0; k < hull.faces[i].size(); ++k) {
        const double bend = dot(hull.normals[i], cross(corner(k + 1) - corner(k), corner(k + 2) - corner(k + 1)));
        EXPECT_GT(bend, -10 * plane_tolerance) << "round " << round;
      }
    }
  }
}

TEST(Hull, OfAThinPlateIsNoMistake) {
  const auto hull = make_hull(box_corners({0.1, 0.1, 1e-4})).hull;
  EXPECT_EQ(hull.faces.size(), 6U);
  EXPECT_NEAR(solid_mass(hull).volume, 8e-6 * 1, 1e-15);
}

TEST(Hull, RefusesWhatHasNoVolume) {
  const auto error = [](const std::vector<Vec3d>& points) { return error_of([&] { (void)make_hull(points); }); };
  EXPECT_TRUE(says(error({}), {"0 points"}));
  EXPECT_TRUE(says(error({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), {"3 points", "at least 4"}));
  EXPECT_TRUE(says(error(std::vector<Vec3d>(10, Vec3d{1, 2, 3})), {"at one place"}));
  Dice dice("flat");
  for (const double thickness : {0.0, 1e-17, 1e-12, 1e-9, 1e-8, 1e-7}) {
    std::vector<Vec3d> line, plane;
    const Mat3d turn = dice.turn();
    for (int i = 0; i < 50; ++i) {
      line.push_back(turn * Vec3d{dice.uniform(-1, 1), 0, 0});
      plane.push_back(turn * Vec3d{dice.uniform(-1, 1), dice.uniform(-1, 1), dice.uniform(0, thickness)});
    }
    EXPECT_TRUE(says(error(line), {"in a plane", "needs a volume"}));
    EXPECT_TRUE(says(error(plane), {"in a plane", "needs a volume"})) << thickness;
  }
}

TEST(Hull, RefusesPointsThatAreNotFinite) {
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL, 1e200}) {
    auto points = box_corners({1, 1, 1});
    points[3].y = bad;
    EXPECT_TRUE(says(error_of([&] { (void)make_hull(points); }), {"not finite"}));
  }
}

TEST(MeshMass, OfABoxAndATetrahedronIsTheirClosedForm) {
  const Vec3d h{0.1, 0.2, 0.3}, middle{3, -4, 5};
  const auto box = solid_mass(make_hull(box_corners(h, middle)).hull);
  EXPECT_NEAR(box.volume, 8 * h.x * h.y * h.z, 1e-15);
  EXPECT_LT(norm(box.center), 1e-15);
  const SymMat3d expected{h.y * h.y + h.z * h.z, h.x * h.x + h.z * h.z, h.x * h.x + h.y * h.y};
  EXPECT_LT(difference(box.inertia, (box.volume / 3) * expected), 1e-15);

  const auto [corner, at, error] = make_hull(std::vector<Vec3d>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  const auto solid = solid_mass(corner);
  EXPECT_NEAR(solid.volume, 1.0 / 6, 1e-15);
  EXPECT_LT(norm(solid.center + at - Vec3d{0.25, 0.25, 0.25}), 1e-15);
  // integral of x^2 is 1/60, of x y 1/120; less V/16 at the center
  const double xx = 1.0 / 60 - 1.0 / 96, xy = 1.0 / 120 - 1.0 / 96;
  EXPECT_LT(difference(solid.inertia, SymMat3d{2 * xx, 2 * xx, 2 * xx, -xy, -xy, -xy}), 1e-15);
}

TEST(MeshMass, OfManyPointsOnASphereIsNearlyThatOfABall) {
  const auto [hull, middle, error] = make_hull(cloud(4000, true));
  const auto solid = solid_mass(hull);
  // a facet of edge a lies about a^2 / 4 under the sphere; 4000 points: a^2 = 0.0036
  EXPECT_NEAR(solid.volume, 4.0 / 3 * pi, 0.02);
  EXPECT_LT(solid.volume, 4.0 / 3 * pi);
  EXPECT_LT(norm(solid.center + middle), 1e-3);
  EXPECT_LT(difference(solid.inertia, diagonal(0.4 * solid.volume)), 0.01);
}

/// An L of 2 x 3 x 1 m with limbs 1 m wide, its outer corner at `at`.
TriangleMesh concave(const Vec3d& at) {
  const std::vector<Vec3d> outline{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}};
  TriangleMesh mesh;
  for (const double z : {0.0, 1.0}) {
    for (const Vec3d& p : outline) mesh.vertices.push_back(at + Vec3d{p.x, p.y, z});
  }
  for (std::uint32_t i = 0; i < 6; ++i) {
    const std::uint32_t j = (i + 1) % 6;
    mesh.triangles.push_back({i, j, j + 6});
    mesh.triangles.push_back({i, j + 6, i + 6});
  }
  for (std::uint32_t i = 2; i < 6; ++i) {
    mesh.triangles.push_back({0, i, i - 1});
    mesh.triangles.push_back({6, i + 5, i + 6});
  }
  return mesh;
}

/// Two boxes that make the L: centers (0.5, 1.5, 0.5) and (1.5, 0.5, 0.5), volumes 3 and 1.
TEST(MeshMass, OfAConcaveMeshIsTheSumOfItsBoxes) {
  const Vec3d at{-7, 2, 1};
  const TriangleMesh mesh = concave(at);
  ASSERT_TRUE(find_seams(mesh).closed());
  const auto solid = solid_mass(mesh);
  const Vec3d center{0.75, 1.25, 0.5};
  EXPECT_NEAR(solid.volume, 4, 1e-13);
  EXPECT_LT(norm(solid.center - at - center), 1e-13);
  SymMat3d expected =
      3 * inertia_of_point(Vec3d{0.5, 1.5, 0.5} - center) + inertia_of_point(Vec3d{1.5, 0.5, 0.5} - center);
  expected += SymMat3d{3 * (9 + 1) / 12.0, 3 * (1 + 1) / 12.0, 3 * (9 + 1) / 12.0};
  expected += SymMat3d{2 / 12.0, 2 / 12.0, 2 / 12.0};
  EXPECT_LT(difference(solid.inertia, expected), 1e-12);
}

TEST(MeshMass, OfAMeshInsideOutIsNegative) {
  TriangleMesh mesh = concave({});
  for (auto& triangle : mesh.triangles) std::swap(triangle[0], triangle[1]);
  EXPECT_NEAR(solid_mass(mesh).volume, -4, 1e-13);
  EXPECT_LT(norm(solid_mass(mesh).center - Vec3d{0.75, 1.25, 0.5}), 1e-13);
  EXPECT_EQ(summed_mass(mesh).volume, summed_mass(concave({})).volume);
}

TEST(MeshMass, SummedEqualsExactForConvexMeshesAndExceedsItForOthers) {
  const auto mesh = triangles_of(make_hull(cloud(300, false)).hull);
  const auto exact = solid_mass(mesh), summed = summed_mass(mesh);
  EXPECT_NEAR(summed.volume, exact.volume, 1e-13);
  EXPECT_LT(norm(summed.center - exact.center), 1e-13);
  EXPECT_LT(difference(summed.inertia, exact.inertia), 1e-13);
  EXPECT_GT(summed_mass(concave({})).volume, 4.1);
}

TEST(MeshMass, OfAShellIsTheSumOfItsSides) {
  const auto shell = shell_mass(triangles_of(make_hull(box_corners({0.5, 0.5, 0.5}, {1, 2, 3})).hull));
  EXPECT_NEAR(shell.volume, 6, 1e-13);
  EXPECT_LT(norm(shell.center), 1e-13);
  // per axis: two sides across it with 1/6, four along it with 1/12 + 1/4
  EXPECT_LT(difference(shell.inertia, diagonal(2.0 / 6 + 4.0 / 3)), 1e-13);
}

TEST(TriangleMesh, MergesCornersAtTheSamePlace) {
  TriangleMesh mesh{{{0, 0, 0}, {9, 9, 9}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}},
                    {{0, 2, 3}, {4, 6, 5}}};
  merge_vertices(mesh);
  EXPECT_EQ(mesh.vertices.size(), 4U);
  EXPECT_EQ(mesh.triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {1, 3, 2}}));
}

TEST(TriangleMesh, FindsOpenAndFlippedEdges) {
  TriangleMesh mesh = triangles_of(make_hull(box_corners({1, 1, 1})).hull);
  EXPECT_TRUE(find_seams(mesh).closed());
  std::swap(mesh.triangles[3][0], mesh.triangles[3][1]);
  EXPECT_EQ(find_seams(mesh).open, 0U);
  EXPECT_EQ(find_seams(mesh).flipped, 3U);
  mesh.triangles.erase(mesh.triangles.begin() + 3);
  EXPECT_EQ(find_seams(mesh).open, 3U);
  EXPECT_EQ(find_seams(mesh).flipped, 0U);
}

TEST(Hull, ThinsOutManyPointsWithinItsBound) {
  const std::vector<Vec3d> points = cloud(static_cast<int>(many_points) + 1, true);
  const auto [hull, middle, error] = make_hull(points);
  expect_proper(hull);
  EXPECT_LT(hull.vertices.size(), points.size() / 2);
  EXPECT_NEAR(error, thinning, 1e-3 * thinning);
  Dice dice("directions of a hull");
  for (int i = 0; i < 100; ++i) {
    const Vec3d direction = dice.unit();
    const double inside = reach(points, direction) - reach(hull.vertices, direction) - dot(middle, direction);
    EXPECT_GE(inside, -1e-15);
    EXPECT_LE(inside, error);
  }
}

TEST(Hull, LeavesNothingOutOfFewPoints) {
  const std::vector<Vec3d> points = cloud(2000, true);
  const auto [hull, middle, error] = make_hull(points);
  EXPECT_EQ(hull.vertices.size(), points.size());
  EXPECT_EQ(error, 0);
}

}  // namespace
}  // namespace murosimf::geometry
