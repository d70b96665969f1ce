/// mjcf_mesh.h - meshes of an MJCF file: their place, their convex parts and their mass.
///
/// A vertex v of the file stands at scale * (R(refquat)^T (v - refpos)) in the mesh frame, which is the frame of the geom.
/// Files are found and scaled as MuJoCo does, read when a geom uses them first, and once.
/// Contact uses convex hulls: of the whole mesh, or of each object or group of an OBJ file where the TOML file beside
/// the robot requests it (`[meshes] part_per_group`).
/// Source: MuJoCo documentation, XML reference, "asset/mesh".
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "murosimf/geometry/mesh_mass.h"
#include "murosimf/model/shape.h"
#include "murosimf/robot_formats/mesh/mesh_library.h"
#include "murosimf/robot_formats/mjcf/mjcf_frame.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot_formats::mjcf {

/// The meshes of an MJCF file by their names. Lines that look wrong go to `warnings`, each once.
class MjcfMeshes {
 public:
  /// `file`: the MJCF file. Throws SetupError for a mesh without a name or with a taken one.
  /// `part_per_group`: meshes that are split into convex parts by their objects or groups.
  MjcfMeshes(const std::filesystem::path& file, const files::XmlElement& root, const MjcfDefaults& defaults,
             const MjcfCompiler& compiler, const std::vector<std::string>& part_per_group,
             std::vector<std::string>& warnings);
  ~MjcfMeshes();
  MjcfMeshes(const MjcfMeshes&) = delete;
  MjcfMeshes& operator=(const MjcfMeshes&) = delete;

  /// Convex parts for the geom `user`, which collides.
  /// Throws SetupError: the line of the mesh, the mesh file and its line, what is wrong.
  [[nodiscard]] const std::vector<robot_formats::mesh::ConvexPart>& parts(const std::string& name,
                                                                          const files::XmlElement& user);

  /// For a visual geom: the mesh is not read. Throws SetupError for an unknown mesh; a missing file is a
  /// warning.
  void check_file(const std::string& name, const files::XmlElement& user);

  /// Material of geoms that use the mesh and have none of their own; empty: none. Throws SetupError for an unknown mesh.
  [[nodiscard]] std::string material(const std::string& name, const files::XmlElement& user);

  /// In alphabetical order.
  [[nodiscard]] std::vector<robot_formats::MeshDescription> descriptions() const;

  /// Mass properties at density 1, by the mesh's attribute `inertia`: legacy (default), exact, convex or shell.
  /// Throws SetupError as `parts`; for a flat mesh unless it is a shell; for exact if it is not closed or inside out.
  [[nodiscard]] geometry::SolidMass mass(const std::string& name, const files::XmlElement& user);

 private:
  struct Mesh;
  Mesh& find(const std::string& name, const files::XmlElement& user);
  Mesh& loaded(const std::string& name, const files::XmlElement& user);
  void load(const std::string& name, Mesh& mesh);
  static geometry::SolidMass exact_mass(const Mesh& mesh);
  [[nodiscard]] std::filesystem::path path_of(const MjcfAttributes& attributes) const;
  const robot_formats::mesh::MeshFile& file_of(const MjcfAttributes& attributes);
  void warn(const Mesh& mesh, const std::string& message);

  std::map<std::string, std::unique_ptr<Mesh>> meshes_;
  std::map<std::filesystem::path, robot_formats::mesh::MeshFile> files_;  ///< read so far
  std::filesystem::path folder_;                                          ///< of mesh files
  bool strip_path_;
  const std::vector<std::string>& part_per_group_;
  std::vector<std::string>& warnings_;
};

}  // namespace murosimf::robot_formats::mjcf
