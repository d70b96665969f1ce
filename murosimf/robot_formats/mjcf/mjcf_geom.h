/// mjcf_geom.h - geoms of an MJCF file: shape, place, surface and mass.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "murosimf/robot_formats/mjcf/mjcf_material.h"
#include "murosimf/robot_formats/mjcf/mjcf_mesh.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot_formats::mjcf {

/// One geom: shapes, several if it is a mesh of several convex parts, or a visual mesh.
struct MjcfGeom {
  std::vector<PlacedShape> shapes;
  std::vector<Vec3d> middles;  ///< [m] for each shape: its origin in the mesh frame
  std::optional<robot_formats::VisualDescription> visual;
  robot_formats::MassProperties solid;  ///< from `mass`, or from `density` [kg/m^3] (1000 by default)
};

/// Data of the file that read_geom depends on.
struct MjcfGeomContext {
  const MjcfCompiler& compiler;
  MjcfMeshes& meshes;
  const MjcfMaterials& materials;
  bool mass_counts = true;  ///< no inertial of the body replaces it; otherwise the mass of a mesh is left at zero
  bool lenient = false;     ///< a mesh that cannot be used is left out, with a line in `warnings`
  std::vector<std::string>& warnings;
};

/// Place of a geom or site with `fromto`: in the middle, z from the second end to the first.
struct MjcfSpan {
  Vec3d middle;
  Mat3d turn;
  double half_length = 0;  ///< [m]
  [[nodiscard]] Transformd place() const { return {middle, turn}; }
};
/// Throws SetupError for equal ends.
[[nodiscard]] MjcfSpan between_ends(const MjcfAttributes& attributes);

/// Reads a geom. Places are those of the geom in its frame. Nothing at all for a mesh that is left out because of `lenient`.
[[nodiscard]] MjcfGeom read_geom(const MjcfAttributes& attributes, const MjcfGeomContext& context);

}  // namespace murosimf::robot_formats::mjcf
