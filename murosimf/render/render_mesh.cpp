#include "murosimf/render/render_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "murosimf/math/assert.h"

namespace murosimf::render {
namespace {

std::array<float, 3> floats(const Vec3d& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

/// [1] Circumradius of a polygon with the area of the unit circle: n / 2 sin(2 pi / n) r^2 = pi.
double equal_area_radius(int segments) { return std::sqrt(2 * pi / (segments * std::sin(2 * pi / segments))); }

/// Adds the quadrilateral of four corners, counterclockwise.
void add_quad(RenderMesh& solid, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  MUROSIMF_ASSERT(std::max({a, b, c, d}) < solid.corners.size());
  solid.triangles.insert(solid.triangles.end(), {a, b, c, a, c, d});
}

/// Part of a unit sphere from latitude `low` to pi / 2 [rad].
RenderMesh sphere_cap(int segments, int rings, double low) {
  MUROSIMF_ASSERT(segments >= 3 && rings >= 1);
  const double r = equal_area_radius(segments);
  RenderMesh solid;
  for (int i = 0; i <= rings; ++i) {
    const double latitude = low + (0.5 * pi - low) * i / rings;
    for (int k = 0; k < segments; ++k) {
      const double longitude = 2 * pi * k / segments;
      const Vec3d n{std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
                    std::sin(latitude)};
      solid.corners.push_back({floats(r * n), floats(n)});
    }
  }
  const auto at = [&](int ring, int k) { return static_cast<std::uint32_t>(ring * segments + k % segments); };
  const bool whole = low < -0.25 * pi;
  for (int i = 0; i < rings; ++i) {
    for (int k = 0; k < segments; ++k) {
      const std::uint32_t a = at(i, k), b = at(i, k + 1), c = at(i + 1, k + 1), d = at(i + 1, k);
      // At the poles one side has no length.
      if (i > 0 || !whole) solid.triangles.insert(solid.triangles.end(), {a, b, c});
      if (i + 1 < rings) solid.triangles.insert(solid.triangles.end(), {a, c, d});
    }
  }
  return solid;
}

void add_lids(RenderMesh& solid, int segments) {
  MUROSIMF_ASSERT(segments >= 3);
  const double r = equal_area_radius(segments);
  for (const double side : {1.0, -1.0}) {
    const auto first = static_cast<std::uint32_t>(solid.corners.size());
    for (int k = 0; k < segments; ++k) {
      const double angle = side * 2 * pi * k / segments;
      solid.corners.push_back({floats({r * std::cos(angle), r * std::sin(angle), side}), floats({0, 0, side})});
    }
    for (int k = 1; k + 1 < segments; ++k) {
      const auto corner = static_cast<std::uint32_t>(k);
      solid.triangles.insert(solid.triangles.end(), {first, first + corner, first + corner + 1});
    }
  }
}

struct MeshTriangle {
  std::size_t number;
  std::array<std::uint32_t, 3> corners;
  Vec3d area;    // [m^2] normal times twice the area
  Vec3d normal;  // unit
};

std::vector<MeshTriangle> with_normals(std::span<const Vec3d> vertices,
                                       std::span<const std::array<std::uint32_t, 3>> triangles) {
  std::vector<MeshTriangle> result;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto& t = triangles[i];
    MUROSIMF_ASSERT(t[0] < vertices.size() && t[1] < vertices.size() && t[2] < vertices.size());
    const Vec3d area = cross(vertices[t[1]] - vertices[t[0]], vertices[t[2]] - vertices[t[0]]);
    const double size = norm(area);
    if (size > 0 && std::isfinite(size)) result.push_back({i, t, area, (1 / size) * area});
  }
  return result;
}

}  // namespace

RenderMesh unit_sphere(int segments) { return sphere_cap(segments, segments / 2, -0.5 * pi); }
RenderMesh unit_half_sphere(int segments) { return sphere_cap(segments, segments / 4, 0); }

RenderMesh unit_tube(int segments) {
  MUROSIMF_ASSERT(segments >= 3);
  const double r = equal_area_radius(segments);
  RenderMesh solid;
  for (int k = 0; k < segments; ++k) {
    const double angle = 2 * pi * k / segments;
    const Vec3d n{std::cos(angle), std::sin(angle), 0};
    solid.corners.push_back({floats(r * n - Vec3d{0, 0, 1}), floats(n)});
    solid.corners.push_back({floats(r * n + Vec3d{0, 0, 1}), floats(n)});
  }
  for (int k = 0; k < segments; ++k) {
    const auto a = static_cast<std::uint32_t>(2 * k), b = static_cast<std::uint32_t>(2 * ((k + 1) % segments));
    add_quad(solid, a, b, b + 1, a + 1);
  }
  return solid;
}

RenderMesh unit_cylinder(int segments) {
  RenderMesh solid = unit_tube(segments);
  add_lids(solid, segments);
  return solid;
}

RenderMesh unit_box() {
  RenderMesh solid;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      const auto first = static_cast<std::uint32_t>(solid.corners.size());
      for (const auto& [a, b] : {std::pair{-1, -1}, std::pair{1, -1}, std::pair{1, 1}, std::pair{-1, 1}}) {
        std::array<double, 3> p{};
        p[axis] = side;
        p[(axis + 1) % 3] = a;
        p[(axis + 2) % 3] = b * side;
        std::array<double, 3> n{};
        n[axis] = side;
        solid.corners.push_back({floats({p[0], p[1], p[2]}), floats({n[0], n[1], n[2]})});
      }
      add_quad(solid, first, first + 1, first + 2, first + 3);
    }
  }
  return solid;
}

RenderMesh render_mesh_of(const ConvexHull& hull) {
  RenderMesh solid;
  MUROSIMF_ASSERT(hull.normals.size() == hull.faces.size());
  for (std::size_t face = 0; face < hull.faces.size(); ++face) {
    const auto first = static_cast<std::uint32_t>(solid.corners.size());
    for (const std::uint32_t corner : hull.faces[face]) {
      solid.corners.push_back({floats(hull.vertices[corner]), floats(hull.normals[face])});
    }
    for (std::uint32_t k = 1; k + 1 < hull.faces[face].size(); ++k) {
      solid.triangles.insert(solid.triangles.end(), {first, first + k, first + k + 1});
    }
  }
  return solid;
}

RenderMesh render_mesh_of(const geometry::TriangleMesh& mesh, std::shared_ptr<const imaging::MipPicture> picture,
                          double crease) {
  const auto& vertices = mesh.vertices;
  MUROSIMF_ASSERT(!picture || mesh.places.size() == mesh.triangles.size());
  const std::vector<MeshTriangle> faces = with_normals(vertices, mesh.triangles);
  std::vector<std::vector<std::size_t>> at_vertex(vertices.size());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for (const std::uint32_t corner : faces[i].corners) at_vertex[corner].push_back(i);
  }
  const double least = std::cos(crease);
  RenderMesh solid;
  std::map<std::pair<Vertex, std::array<float, 2>>, std::uint32_t> known;
  for (const MeshTriangle& face : faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t vertex = face.corners[k];
      Vec3d sum;
      for (const std::size_t other : at_vertex[vertex]) {
        // Weighted by area, so that the normal does not depend on how a flat part is cut into triangles.
        if (dot(faces[other].normal, face.normal) > least) sum += faces[other].area;
      }
      const Vertex corner{floats(vertices[vertex]), floats((1 / norm(sum)) * sum)};
      std::array<float, 2> place{};
      if (picture) place = {mesh.places[face.number][k][0], 1 - mesh.places[face.number][k][1]};
      const auto [found, is_new] = known.try_emplace({corner, place}, static_cast<std::uint32_t>(solid.corners.size()));
      if (is_new) solid.corners.push_back(corner);
      if (is_new && picture) solid.places.push_back(place);
      solid.triangles.push_back(found->second);
    }
  }
  MUROSIMF_ASSERT(solid.triangles.size() == 3 * faces.size());
  solid.picture = std::move(picture);
  return solid;
}

}  // namespace murosimf::render
