/// mesh_fit.h - primitives in the place of the meshes that collide in a description.
#pragma once

#include <string>
#include <vector>

#include "murosimf/geometry/primitive_fit.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot {

/// One convex part of a mesh, and what stands for it now.
struct MeshFit {
  std::string body, mesh;
  const char* shape = "";  ///< "box", ...
  double overlap = 0;      ///< [1] share of the hull's volume that both have in common
};

/// Every convex part of a mesh becomes a primitive of the volume of its hull, which is what contact saw before. A mesh of a
/// file stays to be looked at, unless its body shows it already. Of several parts the first keeps the name.
std::vector<MeshFit> fit_meshes(robot_formats::RobotDescription& description, geometry::PrimitiveKind kind);

/// "sphere", "capsule", "cylinder", "box" or "best". Throws SetupError for others.
[[nodiscard]] geometry::PrimitiveKind primitive_kind(const std::string& name);

}  // namespace murosimf::robot
