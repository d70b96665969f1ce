/// mesh_mass.h - volume, center and inertia of what a triangle mesh encloses.
///
/// A tetrahedron of volume V with corners 0, a, b, c has the second moment V/20 (a a^T + b b^T + c c^T + s s^T),
/// s = a + b + c; a triangle of area A has A/12 of the same. Tetrahedra from one pivot to all triangles, with the sign of
/// their volume, add up to the solid.
/// Source: Tonon, "Explicit exact formulas for the 3-D tetrahedron inertia tensor in terms of its vertex coordinates",
/// Journal of Mathematics and Statistics 1 (2004), eqs. 9a-9f, in symmetric form.
#pragma once

#include "murosimf/geometry/triangle_mesh.h"
#include "murosimf/model/shape.h"

namespace murosimf::geometry {

/// A homogeneous body of density 1.
struct SolidMass {
  double volume = 0;  ///< [m^3]
  Vec3d center;       ///< [m] mesh frame
  SymMat3d inertia;   ///< [m^5] at the center, mesh axes
};

/// The enclosed solid, exactly. Volume and inertia are negative for a mesh that is inside out; the mesh must be closed
/// and not flat.
[[nodiscard]] SolidMass solid_mass(const TriangleMesh& mesh);
/// Tetrahedra that all count as positive: those from the center of the surface give the center of mass, those from there
/// volume and inertia. Equal to solid_mass for convex meshes, more for others; defined for meshes with holes, too.
/// Source: MuJoCo documentation, XML reference, mesh inertia "legacy".
[[nodiscard]] SolidMass summed_mass(const TriangleMesh& mesh);
/// The surface alone; "volume" is its area times a thickness of 1 m.
[[nodiscard]] SolidMass shell_mass(const TriangleMesh& mesh);
/// The faces as fans.
[[nodiscard]] TriangleMesh triangles_of(const ConvexHull& hull);
/// Of a convex polyhedron.
[[nodiscard]] SolidMass solid_mass(const ConvexHull& hull);

}  // namespace murosimf::geometry
