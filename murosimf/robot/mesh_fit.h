/// mesh_fit.h - replaces the colliding meshes of a description by primitives.
#pragma once

#include <string>
#include <vector>

#include "murosimf/geometry/primitive_fit.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot {

/// One convex part of a mesh, and the primitive that replaces it.
struct MeshFit {
  std::string body, mesh;
  const char* shape = "";  ///< "box", ...
  double overlap = 0;      ///< [1] common volume as a share of the hull's volume
};

/// Each convex part of a mesh becomes a primitive of the volume of its hull, which contact used before. A mesh of a
/// file remains as a visual, unless its body has it as one already. Of several parts the first keeps the name.
std::vector<MeshFit> fit_meshes(robot_formats::RobotDescription& description, geometry::PrimitiveKind kind);

/// "sphere", "capsule", "cylinder", "box" or "best". Throws SetupError for others.
[[nodiscard]] geometry::PrimitiveKind primitive_kind(const std::string& name);

}  // namespace murosimf::robot
