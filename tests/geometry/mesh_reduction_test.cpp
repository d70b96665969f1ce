// Meshes with fewer triangles: how many, how far from the surface they were made of, and what becomes of noise.
#include "murosimf/geometry/mesh_reduction.h"

#include <cmath>
#include <numbers>

#include "murosimf/geometry/edge_collapse.h"
#include "murosimf/geometry/vertex_clusters.h"
#include "tests/fixtures.h"

namespace murosimf::geometry {
namespace {

/// A sphere about `middle`: `rings` rings of twice as many squares, cut into triangles.
TriangleMesh sphere(double radius, int rings, const Vec3d& middle = {}) {
  TriangleMesh mesh;
  const int around = 2 * rings;
  for (int i = 0; i <= rings; ++i) {
    for (int j = 0; j < around; ++j) {
      const double polar = std::numbers::pi * i / rings, turn = 2 * std::numbers::pi * j / around;
      const double s = i == 0 || i == rings ? 0 : std::sin(polar);
      mesh.vertices.push_back(middle + radius * Vec3d{s * std::cos(turn), s * std::sin(turn), std::cos(polar)});
    }
  }
  const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(i * around + j % around); };
  for (int i = 0; i < rings; ++i) {
    for (int j = 0; j < around; ++j) {
      if (i > 0) mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
      if (i < rings - 1) mesh.triangles.push_back({at(i, j + 1), at(i + 1, j), at(i + 1, j + 1)});
    }
  }
  merge_vertices(mesh);
  return mesh;
}

std::size_t count(const std::vector<TriangleMesh>& meshes) {
  std::size_t triangles = 0;
  for (const TriangleMesh& mesh : meshes) triangles += mesh.triangles.size();
  return triangles;
}

/// Largest distance of points on the triangles from the sphere about the origin.
double deviation(const TriangleMesh& mesh, double radius) {
  double worst = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3d middle = (1.0 / 3) * (mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c]);
    for (const Vec3d& p : {mesh.vertices[a], middle}) worst = std::max(worst, std::abs(norm(p) - radius));
  }
  return worst;
}

bool is_same(const TriangleMesh& a, const TriangleMesh& b) {
  if (a.triangles != b.triangles || a.vertices.size() != b.vertices.size()) return false;
  for (std::size_t i = 0; i < a.vertices.size(); ++i) {
    if (!is_zero(a.vertices[i] - b.vertices[i])) return false;
  }
  return true;
}

TEST(MeshReduction, LeavesMeshesAloneThatAreSmallEnough) {
  const std::vector<TriangleMesh> meshes{sphere(0.1, 8), sphere(0.2, 6)};
  const MeshReduction same = reduce_meshes(meshes, count(meshes));
  EXPECT_EQ(same.error, 0);
  EXPECT_TRUE(is_same(same.meshes[0], meshes[0]));
  EXPECT_TRUE(is_same(same.meshes[1], meshes[1]));
  EXPECT_LT(count(reduce_meshes(meshes, count(meshes) - 1).meshes), count(meshes));
}

TEST(MeshReduction, KeepsASphereASphere) {
  const MeshReduction reduced = reduce_meshes({sphere(0.1, 160)}, 1000);
  ASSERT_GT(count({sphere(0.1, 160)}), 100'000U);
  EXPECT_LE(count(reduced.meshes), 1000U);
  EXPECT_GT(count(reduced.meshes), 500U) << "the budget is used";
  // a sphere of 1000 triangles has edges of about 1.7 cm, whose middles lie 0.4 mm inside
  EXPECT_LT(deviation(reduced.meshes[0], 0.1), can_collapse_edges() ? 0.002 : 0.01);
  EXPECT_TRUE(!can_collapse_edges() || find_seams(reduced.meshes[0]).closed());
}

// Rule: one error for all. Spheres of r and 4 r need triangles in the ratio 1 to 4 (edge length goes with sqrt(r e)).
TEST(MeshReduction, SharesTrianglesByForm) {
  const auto reduced = reduce_meshes({sphere(0.02, 60), sphere(0.08, 60)}, 1000).meshes;
  const double ratio = static_cast<double>(reduced[1].triangles.size()) / reduced[0].triangles.size();
  EXPECT_GT(ratio, 2);
  EXPECT_LT(ratio, can_collapse_edges() ? 8 : 20);
}

TEST(MeshReduction, BringsTrianglesThatFitTogetherNowhereDown) {
  fixtures::Dice random("soup");
  TriangleMesh soup;
  for (std::uint32_t i = 0; i < 100'000; ++i) {
    const Vec3d p = random.vector(0.2);
    for (int k = 0; k < 3; ++k) soup.vertices.push_back(p + random.vector(0.004));
    soup.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  EXPECT_LE(count(reduce_meshes({soup, sphere(0.1, 20)}, 500).meshes), 500U);
}

TEST(MeshReduction, MakesAFlatGridFewTriangles) {
  TriangleMesh grid;
  const std::uint32_t side = 230;
  for (std::uint32_t i = 0; i < side * side; ++i) grid.vertices.push_back({1e-3 * (i / side), 1e-3 * (i % side), 0});
  for (std::uint32_t i = 0; i + 1 < side; ++i) {
    for (std::uint32_t j = 0; j + 1 < side; ++j) {
      const std::uint32_t a = i * side + j, b = a + side;
      grid.triangles.push_back({a, b, a + 1});
      grid.triangles.push_back({a + 1, b, b + 1});
    }
  }
  const MeshReduction reduced = reduce_meshes({grid}, 300);
  EXPECT_LE(count(reduced.meshes), 300U);
  double area = 0;
  for (const auto& [a, b, c] : reduced.meshes[0].triangles) {
    const auto& v = reduced.meshes[0].vertices;
    area += 0.5 * cross(v[b] - v[a], v[c] - v[a]).z;
  }
  EXPECT_NEAR(area, 0.229 * 0.229, 0.01 * 0.229 * 0.229) << "its outline stays";
}

TEST(MeshReduction, TheSameMeshesGiveTheSameAnswer) {
  const auto once = reduce_meshes({sphere(0.1, 40), sphere(0.05, 40)}, 700);
  const auto again = reduce_meshes({sphere(0.1, 40), sphere(0.05, 40)}, 700);
  EXPECT_EQ(once.error, again.error);
  for (int i = 0; i < 2; ++i) EXPECT_TRUE(is_same(once.meshes[i], again.meshes[i]));
}

TEST(MeshReduction, OfNothingIsNothing) {
  EXPECT_TRUE(reduce_meshes({}, 0).meshes.empty());
  EXPECT_EQ(count(reduce_meshes({sphere(0.1, 10), TriangleMesh{}}, 0).meshes), 0U);
  const TriangleMesh point{{{1, 2, 3}}, {{0, 0, 0}, {0, 0, 0}}};
  EXPECT_EQ(count(reduce_meshes({point}, 1).meshes), 0U);
}

TEST(VertexClusters, MoveNoVertexFartherThanACellReaches) {
  const TriangleMesh fine = sphere(0.1, 60), coarse = cluster_vertices(fine, 0.02);
  EXPECT_LT(coarse.triangles.size(), fine.triangles.size() / 10);
  for (const Vec3d& v : coarse.vertices) EXPECT_NEAR(norm(v), 0.1, 1e-12) << "they are vertices of the mesh";
  for (const Vec3d& v : fine.vertices) {
    double nearest = 1;
    for (const Vec3d& kept : coarse.vertices) nearest = std::min(nearest, norm(v - kept));
    EXPECT_LE(nearest, std::sqrt(3) * 0.02);
  }
}

TEST(VertexClusters, KeepNoTriangleTwice) {
  TriangleMesh twice = sphere(0.1, 6);
  const std::size_t once = cluster_vertices(twice, 1e-6).triangles.size();
  EXPECT_EQ(once, twice.triangles.size());
  twice.triangles.insert(twice.triangles.end(), twice.triangles.begin(), twice.triangles.end());
  EXPECT_EQ(cluster_vertices(twice, 1e-6).triangles.size(), once);
}

TEST(EdgeCollapse, StaysWithinItsError) {
  if (!can_collapse_edges()) GTEST_SKIP() << "this build has no meshoptimizer";
  const TriangleMesh fine = sphere(0.1, 100);
  std::size_t before = fine.triangles.size();
  for (const double error : {1e-4, 1e-3, 5e-3}) {
    const TriangleMesh coarse = collapse_edges(fine, error);
    EXPECT_LT(coarse.triangles.size(), before);
    EXPECT_LT(deviation(coarse, 0.1), 3 * error);
    before = coarse.triangles.size();
  }
}

}  // namespace
}  // namespace murosimf::geometry
