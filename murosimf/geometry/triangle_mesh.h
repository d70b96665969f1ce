/// triangle_mesh.h - triangles with shared corners, as a mesh file holds them, and how well they close.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "murosimf/math/mat3.h"

namespace murosimf::geometry {

struct TriangleMesh {
  std::vector<Vec3d> vertices;                          ///< [m]
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< corners, counterclockwise seen from outside
};

/// Vertices at exactly the same place become one, those of no triangle are dropped; triangles keep their order.
void merge_vertices(TriangleMesh& mesh);

/// Edges that a closed surface does not have.
struct Seams {
  std::size_t open = 0;     ///< edges of an odd number of triangles
  std::size_t flipped = 0;  ///< edges whose triangles do not run through them in both directions equally often
  [[nodiscard]] bool closed() const { return open == 0 && flipped == 0; }
};
[[nodiscard]] Seams find_seams(const TriangleMesh& mesh);

}  // namespace murosimf::geometry
