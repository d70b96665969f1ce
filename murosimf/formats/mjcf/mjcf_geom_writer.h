/// mjcf_geom_writer.h - shapes and meshes of a draft as geoms and assets of an MJCF file.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>

#include "murosimf/description/robot_draft.h"
#include "murosimf/files/xml_text.h"

namespace murosimf::formats::mjcf {

class MjcfGeomWriter {
 public:
  /// `folder`: where the file will stand. Both arguments must live longer.
  MjcfGeomWriter(const description::RobotDraft& draft, const std::filesystem::path& folder, files::XmlText& xml);

  /// All meshes whose files can be read, as `asset`; of one whose vertices stand in the robot file, its hull.
  void write_assets();
  /// Shapes and meshes for the eye; convex parts of one mesh are one geom.
  void write_geoms(const description::DraftBody& body);

 private:
  void write_asset(const description::DraftMesh& mesh);
  void write_shape(const description::DraftShape& shape);
  void write_visual(const description::DraftVisual& visual);
  void write_name(const std::string& name);

  const description::RobotDraft& draft_;
  const std::filesystem::path& folder_;
  files::XmlText& xml_;
  std::map<std::string, const description::DraftShape*> inline_meshes_;  ///< a shape that has the hull, by mesh
  std::set<std::string> unusable_;                                       ///< meshes that are left out
  std::set<std::string> taken_;                                          ///< names of geoms so far
};

}  // namespace murosimf::formats::mjcf
