/// vertex_clusters.h - a coarser mesh by merging all vertices of a grid cell: crude, fast, and it works for every mesh.
///
/// Source: Rossignac, Borrel, "Multi-resolution 3D approximations for rendering complex scenes", Modeling in Computer
/// Graphics (1993).
#pragma once

#include "murosimf/geometry/triangle_mesh.h"

namespace murosimf::geometry {

/// Of all vertices in a cube with edges of `cell` [m], above 0, the one that is farthest from the middle of the mesh's
/// box stays, so that the outline does; triangles whose corners come together vanish. No vertex moves by more than
/// sqrt(3) `cell`. The same mesh gives the same answer.
[[nodiscard]] TriangleMesh cluster_vertices(const TriangleMesh& mesh, double cell);

}  // namespace murosimf::geometry
