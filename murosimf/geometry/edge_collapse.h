/// edge_collapse.h - a coarser mesh by drawing edges together, those first that change the surface least.
///
/// The work is that of meshoptimizer, which is optional.
/// Source: Garland, Heckbert, "Surface simplification using quadric error metrics", SIGGRAPH 1997.
#pragma once

#include "murosimf/geometry/triangle_mesh.h"

namespace murosimf::geometry {

/// This build has meshoptimizer.
[[nodiscard]] bool can_collapse_edges();

/// The mesh with as few triangles as an error of `error` [m] allows; its vertices are some of the mesh's. Pieces
/// that are smaller than the error vanish. Without meshoptimizer the mesh as it is.
[[nodiscard]] TriangleMesh collapse_edges(const TriangleMesh& mesh, double error);

}  // namespace murosimf::geometry
