/// mjcf_geom.h - geoms of an MJCF file: shape, place and surface, and the mass that a solid of this shape has.
#pragma once

#include <string>
#include <vector>

#include "murosimf/io/mjcf_mesh.h"
#include "murosimf/model/shape.h"

namespace murosimf::io {

/// Mass, center and inertia of a body or of a part of it.
struct MassProperties {
  double mass = 0;   ///< [kg]
  Vec3d center;      ///< [m] body frame
  SymMat3d inertia;  ///< [kg m^2] at the center, body axes
};

struct MjcfGeom {
  PlacedShape placed;
  MassProperties solid;  ///< from `mass`, or from `density` [kg/m^3] (1000 if the file is silent)
};

/// What read_geom knows of the file.
struct MjcfGeomContext {
  const MjcfCompiler& compiler;
  MjcfMeshes& meshes;
  bool mass_counts = true;  ///< the body has no inertial that replaces it; else the mass of a mesh is left at zero
  bool lenient = false;     ///< a mesh that cannot be used is left out, with a line in `warnings`
  std::vector<std::string>& warnings;
};

/// One shape; of a mesh one for each convex part, of which the first carries the mass of all. None for a mesh that is
/// left out.
[[nodiscard]] std::vector<MjcfGeom> read_geom(const MjcfAttributes& attributes, const MjcfGeomContext& context);

/// [m^3]; zero for a plane.
[[nodiscard]] double volume(const Shape& shape);
/// [kg m^2] of a homogeneous solid of unit mass, at its center of mass, shape axes; zero for a plane.
[[nodiscard]] SymMat3d unit_inertia(const Shape& shape);
/// Several parts as one: center by weights, inertia by the parallel-axis theorem.
[[nodiscard]] MassProperties combined(const std::vector<MassProperties>& parts);

}  // namespace murosimf::io
