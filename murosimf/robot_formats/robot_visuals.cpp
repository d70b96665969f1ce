#include "murosimf/robot_formats/robot_visuals.h"

#include <algorithm>

#include "murosimf/math/assert.h"

namespace murosimf::robot_formats {

Visuals visuals_of(const RobotDescription& description, const BodyDescription& body) {
  Visuals visuals;
  for (const VisualDescription& visual : body.visuals) {
    MUROSIMF_ASSERT(!visual.mesh.empty());
    const auto mesh = std::ranges::find(description.meshes, visual.mesh, &MeshDescription::name);
    if (mesh == description.meshes.end() || mesh->file.empty()) continue;
    // Vertices in the robot file itself have no file that the drawing could read again.
    visuals.push_back({mesh->file.string(), mesh->scale, mesh->origin.position, mesh->origin.orientation,
                       visual.place.position, visual.place.orientation, visual.color, visual.mesh_colors,
                       visual.picture, visual.picture_repeat});
  }
  return visuals;
}

}  // namespace murosimf::robot_formats
