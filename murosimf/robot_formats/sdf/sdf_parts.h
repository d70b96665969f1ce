/// sdf_parts.h - links and joints of the robot in an SDF file, as they are written, including those of its includes.
///
/// The robot is the model at the top of the file, or of the models of its first world the one with the most joints, then the first that
/// is not static. Names in nested models are those of Gazebo: "arm::upper"; an include with `merge` adds its links as if they stood in its place.
/// A URI is relative to its file, absolute, `file://...`, or of a package (robot_formats/urdf/package_folders.h): `model://name`
/// is a folder with a `model.config`, a `model.sdf`, or a file in it.
/// Sources: SDFormat specification, "include"; documentation of Gazebo, "model.config".
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "murosimf/files/xml_element.h"
#include "murosimf/robot_formats/reader_options.h"
#include "murosimf/robot_formats/urdf/urdf_log.h"

namespace murosimf::robot_formats::sdf {

struct SdfPart {
  std::string name;
  files::XmlElement element;
  std::filesystem::path file;  ///< that contains it
};

/// One model with its contents.
struct SdfModel {
  std::string name;
  files::XmlElement element;
  bool is_static = false;
  std::vector<SdfPart> links, joints;  ///< as in the files
};

class SdfFile {
 public:
  /// Throws SetupError: no such file, no XML, no model in it, an include that is not found or that includes itself.
  SdfFile(std::filesystem::path file, const robot_formats::ReaderOptions& options, urdf::UrdfLog& log);

  [[nodiscard]] const SdfModel& robot() const { return models_[robot_]; }
  /// Its name in the world; empty: it is at the top of the file.
  [[nodiscard]] std::string name_in_world() const { return in_world_ ? robot().name : ""; }
  /// Files of the URIs of includes.
  [[nodiscard]] const std::map<std::string, std::filesystem::path>& includes() const { return includes_; }
  /// Roots of the file and of all included ones.
  [[nodiscard]] std::vector<files::XmlElement> roots() const;

 private:
  struct Source {
    std::filesystem::path file;
    files::XmlElement root;
  };
  void read_world(const files::XmlElement& world);
  void add_model(const files::XmlElement& element, const std::filesystem::path& file, const std::string& name);
  void walk(const files::XmlElement& element, const std::filesystem::path& file, const std::string& scope,
            SdfModel& model, int depth);
  void walk_include(const files::XmlElement& include, const std::filesystem::path& file, const std::string& scope,
                    SdfModel& model, int depth);
  [[nodiscard]] Source open(const files::XmlElement& include, const std::filesystem::path& from);
  [[nodiscard]] std::filesystem::path find(const files::XmlElement& include, const std::string& uri,
                                           const std::filesystem::path& from) const;
  void choose();

  std::filesystem::path file_;
  const robot_formats::ReaderOptions& options_;
  urdf::UrdfLog& log_;
  std::map<std::filesystem::path, std::unique_ptr<files::XmlFile>> files_;
  std::map<std::string, std::filesystem::path> includes_;
  std::vector<SdfModel> models_;
  std::size_t robot_ = 0;
  std::size_t parts_ = 0;  ///< so far
  bool in_world_ = false;
};

}  // namespace murosimf::robot_formats::sdf
