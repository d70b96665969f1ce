/// render_mesh.h - surfaces as triangles with normals, for drawing.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "murosimf/geometry/triangle_mesh.h"
#include "murosimf/imaging/mip_picture.h"
#include "murosimf/math/vec3.h"
#include "murosimf/model/shape.h"

namespace murosimf::render {

/// A corner: place [m] and unit normal, in the frame of the solid.
struct Vertex {
  std::array<float, 3> place{}, normal{};
  friend bool operator==(const Vertex&, const Vertex&) = default;
  friend bool operator<(const Vertex& a, const Vertex& b) {
    return a.place != b.place ? a.place < b.place : a.normal < b.normal;
  }
};

struct RenderMesh {
  std::vector<Vertex> corners;
  std::vector<std::uint32_t> triangles;  ///< three corners each, counterclockwise seen from outside
  std::vector<std::array<float, 2>>
      places{};  ///< [1] by corner, in the picture: to the right and down from its upper left corner
  std::shared_ptr<const imaging::MipPicture> picture{};  ///< its light multiplies that of the color; null: none
  [[nodiscard]] std::size_t triangle_count() const { return triangles.size() / 3; }
};

/// Round solids have `segments` around (a multiple of 4). Seen along their axis they cover the same area as the exact shape:
/// their corners stand out a little, the middles of their sides stand in. From aside a sphere covers up to a
/// share of 5.5 / segments^2 less.
[[nodiscard]] RenderMesh unit_sphere(int segments);       ///< radius 1
[[nodiscard]] RenderMesh unit_half_sphere(int segments);  ///< radius 1, z > 0, open below
[[nodiscard]] RenderMesh unit_tube(int segments);         ///< radius 1, z from -1 to 1, open
[[nodiscard]] RenderMesh unit_cylinder(int segments);     ///< the same, closed
[[nodiscard]] RenderMesh unit_box();                      ///< from -1 to 1

/// The mesh of a hull, with flat faces.
[[nodiscard]] RenderMesh render_mesh_of(const ConvexHull& hull);

/// The mesh of triangles. Those that meet at less than `crease` [rad] are shaded as one smooth surface; those without area are
/// left out. A mesh with places in a picture keeps these; they need one.
[[nodiscard]] RenderMesh render_mesh_of(const geometry::TriangleMesh& mesh,
                                        std::shared_ptr<const imaging::MipPicture> picture = nullptr,
                                        double crease = 0.7);

}  // namespace murosimf::render
