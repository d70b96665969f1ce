/// triangle_mesh.h - triangles with shared corners, as a mesh file holds them, and how well they close.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "murosimf/math/mat3.h"

namespace murosimf::geometry {

/// Places of a triangle's corners in a picture [1]: to the right and up from the lower left corner, which is (0, 0); the upper right one is
/// (1, 1), and the picture repeats beyond.
using PicturePlaces = std::array<std::array<float, 2>, 3>;

struct TriangleMesh {
  std::vector<Vec3d> vertices;                          ///< [m]
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< corners, counterclockwise seen from outside
  std::vector<PicturePlaces> places{};                  ///< by triangle, in a picture; empty: none
};

/// Vertices at exactly the same place become one, those of no triangle are dropped; triangles keep their order, and their places.
void merge_vertices(TriangleMesh& mesh);

/// Edges that a closed surface does not have.
struct Seams {
  std::size_t open = 0;     ///< edges of an odd number of triangles
  std::size_t flipped = 0;  ///< edges whose triangles do not run through them in both directions equally often
  [[nodiscard]] bool closed() const { return open == 0 && flipped == 0; }
};
[[nodiscard]] Seams find_seams(const TriangleMesh& mesh);

}  // namespace murosimf::geometry
