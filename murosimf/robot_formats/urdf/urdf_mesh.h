/// urdf_mesh.h - meshes of a URDF file: entered once, and read once, on first use in a collision.
///
/// A mesh is named after the stem of its file; another file or another scale with the same stem gets a number.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/robot_formats/mesh/mesh_library.h"
#include "murosimf/robot_formats/reader_options.h"
#include "murosimf/robot_formats/robot_description.h"
#include "murosimf/robot_formats/urdf/urdf_log.h"
#include "murosimf/robot_formats/urdf/urdf_mesh_path.h"

namespace murosimf::robot_formats::urdf {

class UrdfMeshes {
 public:
  UrdfMeshes(UrdfMeshPaths paths, std::vector<std::string> part_per_group, robot_formats::RobotDescription& description,
             UrdfLog& log)
      : paths_(std::move(paths)), part_per_group_(std::move(part_per_group)), description_(description), log_(log) {}

  /// The entry among the description's meshes for a `mesh` element; nothing if its file does not exist.
  [[nodiscard]] std::optional<robot_formats::MeshDescription> find(const files::XmlElement& mesh);
  /// The same for a file by its name, at a scale; `where` [file:line] refers to it.
  [[nodiscard]] std::optional<robot_formats::MeshDescription> find(const std::string& name, const Vec3d& scale,
                                                                   const std::string& where);

  /// The file of a picture, found as meshes are; nothing if it does not exist.
  [[nodiscard]] std::optional<std::filesystem::path> find_picture(const std::string& name) { return paths_.find(name); }

  /// Its convex parts for contact. Throws SetupError: the line of the element, then what is wrong with the mesh.
  [[nodiscard]] const std::vector<robot_formats::mesh::ConvexPart>& parts(const robot_formats::MeshDescription& mesh,
                                                                          const files::XmlElement& user);

  /// The message that there is no such file, with advice. For the last element searched for.
  [[nodiscard]] std::string complaint(const files::XmlElement& mesh) const;
  [[nodiscard]] std::string complaint(const std::string& name) const;

 private:
  UrdfMeshPaths paths_;
  std::vector<std::string> part_per_group_;
  robot_formats::RobotDescription& description_;
  UrdfLog& log_;
  robot_formats::mesh::MeshLibrary library_;
};

}  // namespace murosimf::robot_formats::urdf
