/// solid_test - triangles for drawing: closed, facing outwards, and as large in a picture as their shape.
#include "murosimf/render/render_mesh.h"

#include <cmath>
#include <map>
#include <set>

#include "tests/fixtures.h"

namespace murosimf::render {
namespace {

constexpr std::array segment_counts{8, 16, 32, 64};

Vec3d vec(const std::array<float, 3>& a) { return {a[0], a[1], a[2]}; }

struct Facet {
  std::array<Vec3d, 3> corner, normal;
  [[nodiscard]] Vec3d area() const { return 0.5 * cross(corner[1] - corner[0], corner[2] - corner[0]); }
};

std::vector<Facet> facets(const RenderMesh& solid) {
  std::vector<Facet> result(solid.triangle_count());
  for (std::size_t i = 0; i < solid.triangles.size(); ++i) {
    const Vertex& corner = solid.corners.at(solid.triangles[i]);
    result[i / 3].corner[i % 3] = vec(corner.place);
    result[i / 3].normal[i % 3] = vec(corner.normal);
  }
  return result;
}

/// Edges that are not walked once in each direction; places are distinguished to a micrometer.
std::size_t open_edges(const RenderMesh& solid) {
  using Transformd = std::array<long, 3>;
  const auto place = [&](std::uint32_t corner) {
    const Vec3d p = vec(solid.corners[corner].place);
    return Transformd{std::lround(1e6 * p.x), std::lround(1e6 * p.y), std::lround(1e6 * p.z)};
  };
  std::map<std::pair<Transformd, Transformd>, int> walked;
  for (std::size_t i = 0; i < solid.triangles.size(); i += 3) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Transformd a = place(solid.triangles[i + k]), b = place(solid.triangles[i + (k + 1) % 3]);
      ++walked[{a, b}];
    }
  }
  std::size_t open = 0;
  for (const auto& [edge, times] : walked) {
    const auto back = walked.find({edge.second, edge.first});
    if (back == walked.end() || back->second != times) ++open;
  }
  return open;
}

double surface(const RenderMesh& solid) {
  double sum = 0;
  for (const Facet& facet : facets(solid)) sum += norm(facet.area());
  return sum;
}

/// By the divergence theorem; right for closed solids.
double volume(const RenderMesh& solid) {
  double sum = 0;
  for (const Facet& facet : facets(solid)) sum += dot(facet.area(), facet.corner[0]) / 3;
  return sum;
}

/// [m^2] Area that a convex solid covers, seen along a direction: half the sum over its facets.
double silhouette(const RenderMesh& solid, const Vec3d& direction) {
  double sum = 0;
  for (const Facet& facet : facets(solid)) sum += std::abs(dot(facet.area(), direction));
  return 0.5 * sum;
}

std::vector<RenderMesh> closed_solids(int segments) {
  return {unit_sphere(segments), unit_cylinder(segments), unit_box()};
}

TEST(RenderMesh, ClosedOnesHaveNoHoles) {
  for (const int segments : segment_counts) {
    for (const RenderMesh& solid : closed_solids(segments)) EXPECT_EQ(open_edges(solid), 0u) << segments;
    EXPECT_EQ(open_edges(unit_tube(segments)), 2u * static_cast<unsigned>(segments)) << "its two ends";
    EXPECT_EQ(open_edges(unit_half_sphere(segments)), static_cast<unsigned>(segments)) << "its rim";
  }
}

TEST(RenderMesh, FacesOutwardsAndIsShadedSo) {
  for (const int segments : segment_counts) {
    std::vector<RenderMesh> solids = closed_solids(segments);
    solids.push_back(unit_half_sphere(segments));
    solids.push_back(unit_tube(segments));
    for (const RenderMesh& solid : solids) {
      for (const Facet& facet : facets(solid)) {
        ASSERT_GT(norm(facet.area()), 0) << "no facet without area";
        const Vec3d outward = (1 / norm(facet.area())) * facet.area();
        EXPECT_GT(dot(outward, facet.corner[0]), 0);
        for (const Vec3d& normal : facet.normal) {
          EXPECT_NEAR(norm(normal), 1, 1e-6);
          EXPECT_GT(dot(normal, outward), std::cos(1.1 * 2 * pi / segments)) << "shading follows the facet";
        }
      }
    }
  }
}

TEST(RenderMesh, HasTheSurfaceOfWhatItStandsFor) {
  double last = 1;
  for (const int segments : segment_counts) {
    const double n = segments, error = 7 / (n * n);  // falls with the square
    EXPECT_NEAR(surface(unit_sphere(segments)) / (4 * pi), 1, error) << segments;
    EXPECT_NEAR(surface(unit_half_sphere(segments)) / (2 * pi), 1, error) << segments;
    EXPECT_NEAR(surface(unit_tube(segments)) / (4 * pi), 1, error) << segments;
    EXPECT_NEAR(surface(unit_cylinder(segments)) / (6 * pi), 1, error) << segments;
    EXPECT_NEAR(volume(unit_sphere(segments)) / (4 * pi / 3), 1, error) << segments;
    EXPECT_LT(error, last);
    last = error;
  }
  EXPECT_NEAR(surface(unit_box()), 24, 1e-9);
  EXPECT_NEAR(volume(unit_box()), 8, 1e-9);
}

TEST(RenderMesh, RoundOnesCoverTheRightAreaSeenAlongTheirAxis) {
  for (const int segments : segment_counts) {
    for (const RenderMesh& solid : {unit_sphere(segments), unit_cylinder(segments)}) {
      EXPECT_NEAR(silhouette(solid, {0, 0, 1}), pi, 1e-5) << segments;
    }
    EXPECT_NEAR(volume(unit_cylinder(segments)), 2 * pi, 1e-5) << segments;
  }
}

TEST(RenderMesh, ASphereCoversNearlyTheSameAreaFromEverywhere) {
  for (const int segments : segment_counts) {
    const RenderMesh sphere = unit_sphere(segments);
    for (int i = 0; i < 50; ++i) {
      const double z = -0.98 + 0.04 * i, angle = 2.4 * i, r = std::sqrt(1 - z * z);
      const double share = silhouette(sphere, {r * std::cos(angle), r * std::sin(angle), z}) / pi;
      EXPECT_GT(share, 1 - 5.5 / (segments * segments)) << segments;
      EXPECT_LT(share, 1 + 0.5 / (segments * segments)) << segments;
    }
  }
}

TEST(RenderMesh, OfHullsIsTheirBoundary) {
  for (const Shape& shape : fixtures::shapes_of_all_kinds()) {
    const auto* convex = std::get_if<Convex>(&shape);
    if (!convex) continue;
    const RenderMesh solid = render_mesh_of(*convex->hull);
    EXPECT_EQ(open_edges(solid), 0u);
    EXPECT_GT(volume(solid), 0);
    for (const Facet& facet : facets(solid)) {
      for (const Vec3d& corner : facet.corner) EXPECT_NEAR(fixtures::outside(shape, corner), 0, 1e-6);
      EXPECT_GT(dot(facet.normal[0], facet.area()), 0.999 * norm(facet.area())) << "flat";
    }
  }
}

/// A roof: two squares that meet at the y axis, each going down by `slope` [rad].
std::pair<std::vector<Vec3d>, std::vector<std::array<std::uint32_t, 3>>> roof(double slope) {
  const double x = std::cos(slope), z = -std::sin(slope);
  return {{{0, 0, 0}, {0, 1, 0}, {-x, 0, z}, {-x, 1, z}, {x, 0, z}, {x, 1, z}},
          {{0, 1, 2}, {1, 3, 2}, {0, 4, 5}, {0, 5, 1}}};
}

TEST(RenderMesh, OfMeshesIsSmoothUpToTheCrease) {
  const auto normals_on_ridge = [](double slope) {
    const auto [vertices, triangles] = roof(slope);
    std::set<std::array<float, 3>> normals;
    for (const Vertex& corner : render_mesh_of({vertices, triangles}, nullptr, 0.7).corners) {
      if (corner.place[0] == 0) normals.insert(corner.normal);
    }
    return normals;
  };
  for (const auto& normal : normals_on_ridge(0.3)) EXPECT_GT(normal[2], 0.98) << "0.6 rad: one smooth ridge, upwards";
  for (const auto& normal : normals_on_ridge(0.4)) EXPECT_NEAR(std::abs(normal[0]), std::sin(0.4), 1e-6) << "an edge";
}

TEST(RenderMesh, OfMeshesLeavesTrianglesWithoutAreaOut) {
  const std::vector<Vec3d> vertices{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}};
  const std::vector<std::array<std::uint32_t, 3>> triangles{{0, 1, 2}, {0, 1, 3}, {1, 1, 2}, {0, 2, 1}};
  const RenderMesh solid = render_mesh_of({vertices, triangles});
  EXPECT_EQ(solid.triangle_count(), 2u);
  for (const Vertex& corner : solid.corners) EXPECT_NEAR(std::abs(corner.normal[2]), 1, 1e-6);
  EXPECT_EQ(render_mesh_of(geometry::TriangleMesh{vertices, {}}).triangle_count(), 0u);
}

}  // namespace
}  // namespace murosimf::render
