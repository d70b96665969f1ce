// Meshes with fewer triangles: how many, how far from the surface they were made of, and what becomes of noise.
#include "murosimf/geometry/mesh_reduction.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "murosimf/geometry/error_quadric.h"
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
  EXPECT_GE(count(reduced.meshes), 998U) << "the budget is used";
  // a sphere of 1000 triangles has edges of about 1.7 cm, whose middles lie 0.4 mm inside
  EXPECT_LT(deviation(reduced.meshes[0], 0.1), 0.002);
  EXPECT_GT(reduced.error, 1e-4);
  EXPECT_LT(reduced.error, 0.002);
  EXPECT_TRUE(find_seams(reduced.meshes[0]).closed());
}

// Rule: a triangle of edge l on a sphere of radius r costs about l^2 (l^2 / r)^2; where that is the same everywhere, l goes
// with r^(1/3), and the number of triangles r^2 / l^2 with r^(4/3).
TEST(MeshReduction, SharesTrianglesByForm) {
  const auto reduced = reduce_meshes({sphere(0.02, 60), sphere(0.08, 60)}, 1000).meshes;
  const double ratio = static_cast<double>(reduced[1].triangles.size()) / reduced[0].triangles.size();
  EXPECT_NEAR(ratio, std::pow(4, 4.0 / 3), 1.5);
}

/// A block with `n` squares along each edge; a power of two, or corners differ by rounding.
TriangleMesh block(const Vec3d& half, int n) {
  TriangleMesh mesh;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
      for (int i = 0; i <= n; ++i) {
        for (int j = 0; j <= n; ++j) {
          const std::array<double, 3> p{side, side * (2.0 * i / n - 1), 2.0 * j / n - 1};
          const auto at = [&](int k) { return p[(k - axis + 3) % 3]; };
          mesh.vertices.push_back({half.x * at(0), half.y * at(1), half.z * at(2)});
        }
      }
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
          const std::uint32_t a = first + i * (n + 1) + j, b = a + n + 1;
          mesh.triangles.push_back({a, b, a + 1});
          mesh.triangles.push_back({a + 1, b, b + 1});
        }
      }
    }
  }
  merge_vertices(mesh);
  return mesh;
}

double area(const TriangleMesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    sum += 0.5 * norm(cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]));
  }
  return sum;
}

TEST(MeshReduction, MakesABlockTwelveTriangles) {
  const TriangleMesh fine = block({0.1, 0.2, 0.3}, 16);
  ASSERT_TRUE(find_seams(fine).closed());
  ASSERT_NEAR(area(fine), 8 * (0.02 + 0.03 + 0.06), 1e-12);
  const MeshReduction reduced = reduce_meshes({fine}, 12);
  EXPECT_EQ(count(reduced.meshes), 12U);
  EXPECT_NEAR(area(reduced.meshes[0]), area(fine), 1e-9);
  EXPECT_LT(reduced.error, 1e-5);
}

TEST(MeshReduction, KeepsThinSheetsAndDropsSmallThings) {
  const TriangleMesh sheet = block({0.05, 0.02, 0.0005}, 16), bolt = block({0.002, 0.002, 0.002}, 16);
  const auto reduced = reduce_meshes({sheet, bolt, sphere(0.1, 60)}, 200).meshes;
  EXPECT_NEAR(area(reduced[0]), area(sheet), 0.05 * area(sheet));
  EXPECT_LT(reduced[1].triangles.size(), 13U);
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

TEST(ErrorQuadric, IsTheSumOfSquaredDistances) {
  fixtures::Dice random("planes");
  ErrorQuadric all, some;
  std::vector<std::pair<Vec3d, Vec3d>> planes;
  for (int i = 0; i < 20; ++i) {
    planes.emplace_back(random.unit(), random.vector(1));
    (i % 2 == 0 ? all : some).add_plane(planes.back().first, planes.back().second, 1 + i);
  }
  all += some;
  for (int k = 0; k < 20; ++k) {
    const Vec3d p = random.vector(2);
    double sum = 0;
    for (int i = 0; i < 20; ++i) sum += (1 + i) * std::pow(dot(planes[i].first, p - planes[i].second), 2);
    EXPECT_NEAR(all(p), sum, 1e-9 * sum);
  }
}

/// A wavy sheet of 2 m x 1 m; its picture begins anew in the middle, as `place` says.
TriangleMesh sheet(int cells) {
  TriangleMesh mesh;
  const int columns = 2 * cells;
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= columns; ++i) {
      const double x = static_cast<double>(i) / cells, y = static_cast<double>(j) / cells;
      mesh.vertices.push_back({x, y, 0.05 * std::sin(5 * x) * std::sin(4 * y)});
    }
  }
  const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * (columns + 1) + i); };
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, bool second) {
    mesh.triangles.push_back({a, b, c});
    const auto place = [&](std::uint32_t vertex) {
      const Vec3d& p = mesh.vertices[vertex];
      return std::array{static_cast<float>(second ? 7 - p.x : p.x), static_cast<float>(p.y)};
    };
    mesh.places.push_back({place(a), place(b), place(c)});
  };
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < columns; ++i) {
      add(at(i, j), at(i + 1, j), at(i + 1, j + 1), i >= cells);
      add(at(i, j), at(i + 1, j + 1), at(i, j + 1), i >= cells);
    }
  }
  return mesh;
}

// Law: corners that are left keep their places, and no triangle has corners on both sides of a seam.
TEST(MeshReduction, KeepsPlacesInPictures) {
  const TriangleMesh whole = sheet(20);
  for (const std::size_t most : {800U, 200U, 60U}) {
    const TriangleMesh mesh = reduce_meshes({whole, sphere(0.1, 4)}, most).meshes[0];
    ASSERT_EQ(mesh.places.size(), mesh.triangles.size());
    ASSERT_GT(mesh.triangles.size(), 10U);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      const bool second = mesh.places[i][0][0] > 3;
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3d& p = mesh.vertices[mesh.triangles[i][k]];
        EXPECT_NEAR(mesh.places[i][k][0], second ? 7 - p.x : p.x, 1e-6) << most;
        EXPECT_NEAR(mesh.places[i][k][1], p.y, 1e-6) << most;
      }
    }
  }
  EXPECT_TRUE(reduce_meshes({whole, sphere(0.1, 4)}, 60).meshes[1].places.empty());
}

}  // namespace
}  // namespace murosimf::geometry
