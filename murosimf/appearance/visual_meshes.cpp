#include "murosimf/appearance/visual_meshes.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "murosimf/collision/relief/relief.h"
#include "murosimf/geometry/mesh_mass.h"
#include "murosimf/geometry/mesh_reduction.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"
#include "murosimf/robot_formats/mesh/mesh_file.h"
#include "murosimf/robot_formats/mesh/mesh_library.h"

namespace murosimf::appearance {
namespace {

/// Adds visual meshes. True if one of them is visible.
bool add_visuals(const Model& model, int object, Appearance& appearance) {
  const Visuals* visuals = model.find(properties::visuals, object);
  bool any = false;
  for (const VisualMesh& visual : visuals ? *visuals : Visuals{}) {
    try {
      appearance.meshes.push_back({object, visual_triangles(visual), visual.color});
      any = true;
    } catch (const SetupError& error) {
      appearance.warnings.push_back(
          fmt::format("{}; '{}' is drawn without it", error.what(), model.objects()[object].name));
    }
  }
  return any;
}

void add_shape(const PlacedShape& placed, int object, Appearance& appearance) {
  const Convex* convex = std::get_if<Convex>(&placed.shape);
  if (!convex) {
    appearance.shapes.push_back({object, placed});
    return;
  }
  geometry::TriangleMesh mesh = geometry::triangles_of(*convex->hull);
  for (Vec3d& v : mesh.vertices) v = placed.position + placed.orientation * v;
  appearance.meshes.push_back({object, std::move(mesh), placed.color});
}

void reduce(Appearance& appearance, std::size_t most) {
  std::vector<geometry::TriangleMesh> meshes;
  for (SeenMesh& seen : appearance.meshes) meshes.push_back(std::move(seen.mesh));
  auto [reduced, error] = geometry::reduce_meshes(std::move(meshes), most);
  MUROSIMF_ASSERT(reduced.size() == appearance.meshes.size());
  for (std::size_t i = 0; i < reduced.size(); ++i) appearance.meshes[i].mesh = std::move(reduced[i]);
  std::erase_if(appearance.meshes, [](const SeenMesh& seen) { return seen.mesh.triangles.empty(); });
  appearance.error = error;
}

}  // namespace

geometry::TriangleMesh visual_triangles(const VisualMesh& mesh) {
  const Vec3d& s = mesh.scale;
  if (s.x == 0 || s.y == 0 || s.z == 0) {
    throw SetupError(fmt::format("{}: a scale of 0 makes the mesh flat; correct it", mesh.file));
  }
  geometry::TriangleMesh triangles = robot_formats::mesh::read_mesh_file(mesh.file).mesh;
  for (Vec3d& v : triangles.vertices) v = transposed_times(mesh.file_orientation, v - mesh.file_position);
  robot_formats::mesh::scale_mesh(triangles, s);
  for (Vec3d& v : triangles.vertices) v = mesh.position + mesh.orientation * v;
  return triangles;
}

std::vector<std::string> visual_files(const Model& model) {
  std::vector<std::string> files;
  for (int object = 0; object < model.size(); ++object) {
    const Visuals* visuals = model.find(properties::visuals, object);
    for (const VisualMesh& visual : visuals ? *visuals : Visuals{}) files.push_back(visual.file);
  }
  return files;
}

Appearance appearance_of(const Model& model, std::size_t most) {
  Appearance appearance;
  std::vector<SeenMesh> grounds;  // with all of their triangles: bodies stand on these
  for (int object = 0; object < model.size(); ++object) {
    if (const auto* relief = model.find(properties::relief, object)) {
      grounds.push_back({object, (*relief)->mesh(), model.find(properties::shapes, object)->front().color});
      continue;
    }
    const bool dressed = add_visuals(model, object, appearance);
    const Shapes* shapes = model.find(properties::shapes, object);
    for (const PlacedShape& placed : shapes ? *shapes : Shapes{}) {
      if (!dressed || !placed.collides) add_shape(placed, object, appearance);
    }
  }
  reduce(appearance, most);
  std::ranges::move(grounds, std::back_inserter(appearance.meshes));
  return appearance;
}

}  // namespace murosimf::appearance
