#include "murosimf/description/robot_visuals.h"

#include <algorithm>

namespace murosimf::description {

Visuals visuals_of(const RobotDraft& draft, const DraftBody& body) {
  Visuals visuals;
  for (const DraftVisual& visual : body.visuals) {
    const auto mesh = std::ranges::find(draft.meshes, visual.mesh, &DraftMesh::name);
    if (mesh == draft.meshes.end() || mesh->file.empty()) continue;
    visuals.push_back({mesh->file.string(), mesh->scale, mesh->origin.position, mesh->origin.orientation,
                       visual.place.position, visual.place.orientation, visual.color});
  }
  return visuals;
}

}  // namespace murosimf::description
