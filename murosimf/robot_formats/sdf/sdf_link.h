/// sdf_link.h - mass, shapes and sensors of a link of an SDF file.
///
/// A link without `inertial` weighs 1 kg with 1 kg m^2 about each axis, as the format defines it. Meshes that collide become convex hulls;
/// visual meshes are named, not read. Source: SDFormat specification, "link", "inertial", "collision", "visual".
#pragma once

#include <filesystem>
#include <map>

#include "murosimf/robot_formats/reader_options.h"
#include "murosimf/robot_formats/robot_description.h"
#include "murosimf/robot_formats/sdf/sdf_parts.h"
#include "murosimf/robot_formats/sdf/sdf_poses.h"
#include "murosimf/robot_formats/urdf/urdf_mesh.h"

namespace murosimf::robot_formats::sdf {

class SdfLinks {
 public:
  SdfLinks(const robot_formats::ReaderOptions& options, robot_formats::RobotDescription& description,
           urdf::UrdfLog& log)
      : options_(options), description_(description), log_(log) {}

  /// The body of a link, in its frame, without place and joints. Throws SetupError: impossible sizes and masses, a missing or unreadable
  /// collision mesh. A missing visual mesh is a warning.
  [[nodiscard]] robot_formats::BodyDescription read(const SdfPart& link, const SdfLinkPose& pose);

 private:
  struct Shape {
    files::XmlElement owner;  ///< collision or visual
    Transformd place;         ///< in the link
    bool collides = false;
    Color color{};
    double friction = 0;  ///< [1]
  };
  [[nodiscard]] robot_formats::MassProperties read_inertial(const SdfPart& link, const SdfLinkPose& pose);
  void add_shape(const Shape& shape, urdf::UrdfMeshes& meshes, robot_formats::BodyDescription& body);
  void add_mesh(const Shape& shape, const files::XmlElement& mesh, urdf::UrdfMeshes& meshes,
                robot_formats::BodyDescription& body);
  void warn_of_settings(const files::XmlElement& link);
  [[nodiscard]] urdf::UrdfMeshes& meshes_of(const std::filesystem::path& file);
  [[nodiscard]] double friction_of(const files::XmlElement& collision);

  const robot_formats::ReaderOptions& options_;
  robot_formats::RobotDescription& description_;
  urdf::UrdfLog& log_;
  std::map<std::filesystem::path, urdf::UrdfMeshes> meshes_;  ///< by the file that names them
};

}  // namespace murosimf::robot_formats::sdf
