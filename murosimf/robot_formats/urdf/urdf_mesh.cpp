#include "murosimf/robot_formats/urdf/urdf_mesh.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/model/error.h"
#include "murosimf/robot_formats/mesh_entry.h"
#include "murosimf/robot_formats/urdf/urdf_value.h"

namespace murosimf::robot_formats::urdf {
namespace {

/// The file name of a mesh: "$(find package)/..." is not a macro here but refers to a package as well.
std::string file_name(const files::XmlElement& mesh) {
  const auto name = mesh.attribute("filename");
  const bool of_package = name && (name->starts_with("$(find ") || name->starts_with("$(find-pkg-share "));
  return of_package ? *name : needed_text(mesh, "filename");
}

}  // namespace

std::optional<robot_formats::MeshDescription> UrdfMeshes::find(const files::XmlElement& mesh) {
  return find(file_name(mesh), vector_or(mesh, "scale", {1, 1, 1}), mesh.where());
}

std::optional<robot_formats::MeshDescription> UrdfMeshes::find(const std::string& name, const Vec3d& scale,
                                                               const std::string& where) {
  const auto file = paths_.find(name);
  if (!file) return std::nullopt;
  return robot_formats::mesh_entry(description_, *file, scale, where);
}

const std::vector<robot_formats::mesh::ConvexPart>& UrdfMeshes::parts(const robot_formats::MeshDescription& mesh,
                                                                      const files::XmlElement& user) {
  const bool split = std::ranges::find(part_per_group_, mesh.name) != part_per_group_.end();
  const std::string where = fmt::format("{}: mesh '{}'", user.where(), mesh.name);
  const robot_formats::mesh::SolidMesh& solid = with_context(where, [&]() -> const robot_formats::mesh::SolidMesh& {
    return library_.get(mesh.file, mesh.scale, split);
  });
  if (!solid.flat.empty()) throw SetupError(files::one_line(fmt::format("{}: {}", where, solid.flat)));
  // Reported where the mesh collides: for a visual mesh none of it matters.
  for (const std::string& doubt : robot_formats::mesh::mesh_doubts(solid))
    log_.warn(user, fmt::format("mesh '{}': {}", mesh.name, doubt));
  return solid.parts;
}

std::string UrdfMeshes::complaint(const files::XmlElement& mesh) const { return complaint(file_name(mesh)); }

std::string UrdfMeshes::complaint(const std::string& name) const {
  return fmt::format("there is no mesh file '{}'; {}", name, paths_.advice(name));
}

}  // namespace murosimf::robot_formats::urdf
