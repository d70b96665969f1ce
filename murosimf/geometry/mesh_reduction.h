/// mesh_reduction.h - several meshes made coarser until all together have few enough triangles.
///
/// They share one error, the distance by which the surface moves, since that is what an eye sees: each mesh gets as many
/// triangles as its form needs. The error doubles from level to level, and is then bisected. At each error a mesh is
/// what needs fewer triangles: edges drawn together (edge_collapse.h), or vertices merged (vertex_clusters.h), which
/// works for meshes that fit together nowhere, too.
#pragma once

#include "murosimf/geometry/triangle_mesh.h"

namespace murosimf::geometry {

struct MeshReduction {
  std::vector<TriangleMesh> meshes;  ///< in the order of the given ones; a mesh may have lost all triangles
  double error = 0;                  ///< [m] by which surfaces moved about
};

/// At most `most` triangles in all. Meshes that are few enough stay as they are. The same meshes give the same answer.
[[nodiscard]] MeshReduction reduce_meshes(std::vector<TriangleMesh> meshes, std::size_t most);

}  // namespace murosimf::geometry
