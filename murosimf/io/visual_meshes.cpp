#include "murosimf/io/visual_meshes.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/io/mesh_file.h"
#include "murosimf/io/mesh_library.h"
#include "murosimf/model/error.h"

namespace murosimf::io {

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

geometry::TriangleMesh visual_triangles(const VisualMesh& mesh) {
  const Vec3d& s = mesh.scale;
  if (s.x == 0 || s.y == 0 || s.z == 0) {
    throw SetupError(fmt::format("{}: a scale of 0 makes the mesh flat; correct it", mesh.file));
  }
  geometry::TriangleMesh triangles = read_mesh_file(mesh.file).mesh;
  for (Vec3d& v : triangles.vertices) v = transposed_times(mesh.file_orientation, v - mesh.file_position);
  scale_mesh(triangles, s);
  for (Vec3d& v : triangles.vertices) v = mesh.position + mesh.orientation * v;
  return triangles;
}

}  // namespace murosimf::io
