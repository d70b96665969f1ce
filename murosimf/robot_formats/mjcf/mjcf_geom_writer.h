/// mjcf_geom_writer.h - writes shapes and meshes of a description as geoms and assets of an MJCF file, and places of elements.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>

#include "murosimf/files/xml_text.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot_formats::mjcf {

/// Adds pos and quat to the open element unless they are zero and the identity.
void write_place(files::XmlText& xml, const Transformd& place);

class MjcfGeomWriter {
 public:
  /// `folder`: folder of the future file. All arguments must outlive the object.
  MjcfGeomWriter(const robot_formats::RobotDescription& description, const std::filesystem::path& folder,
                 files::XmlText& xml);

  /// Writes all meshes with readable files as `asset`; of one with its vertices in the robot file, its hull.
  void write_assets();
  /// Writes shapes and visual meshes; convex parts of one mesh are one geom.
  void write_geoms(const robot_formats::BodyDescription& body);

 private:
  void write_asset(const robot_formats::MeshDescription& mesh);
  void write_shape(const robot_formats::ShapeDescription& shape);
  void write_visual(const robot_formats::VisualDescription& visual);
  void write_name(const std::string& name);

  const robot_formats::RobotDescription& description_;
  const std::filesystem::path& folder_;
  files::XmlText& xml_;
  std::map<std::string, const robot_formats::ShapeDescription*> inline_meshes_;  ///< by mesh: a shape with its hull
  std::set<std::string> unusable_;                                               ///< meshes that are left out
  std::set<std::string> taken_;                                                  ///< names of geoms so far
};

}  // namespace murosimf::robot_formats::mjcf
