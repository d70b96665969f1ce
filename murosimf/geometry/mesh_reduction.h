/// mesh_reduction.h - several meshes made coarser until all together have few enough triangles.
///
/// Edges are drawn together one after the other, each time the one that costs least: the squared distance of the
/// triangles' planes from the vertex that is left, times their area. Creases and open borders cost by their length as
/// well, which keeps outlines, thin sheets and the seams of pictures. One queue for all meshes: each gets the triangles
/// that its form needs, and details that are invisible from afar are removed first. Meshes need not be closed, nor fit
/// together anywhere.
/// Source: Garland, Heckbert, "Surface simplification using quadric error metrics", SIGGRAPH 1997.
#pragma once

#include "murosimf/geometry/triangle_mesh.h"

namespace murosimf::geometry {

struct MeshReduction {
  std::vector<TriangleMesh> meshes;  ///< in the order of the given ones; a mesh may have lost all triangles
  double error = 0;                  ///< [m] root mean square of the distance by which surfaces have moved, about
};

/// At most `most` triangles in all, whose corners are vertices of the given meshes. Meshes that are few enough stay as
/// they are. The same meshes give the same answer.
[[nodiscard]] MeshReduction reduce_meshes(std::vector<TriangleMesh> meshes, std::size_t most);

}  // namespace murosimf::geometry
