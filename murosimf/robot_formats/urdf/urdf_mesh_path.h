/// urdf_mesh_path.h - finds the mesh files of a URDF file.
///
/// Names are relative to the URDF file, absolute, file: addresses, or package://name/path; model://name/path and $(find name)/path
/// mean the same. They may have percent escapes, backslashes and other capital letters than the file (files/file_spelling.h).
/// Packages are found as described in package_folders.h.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/robot_formats/urdf/package_folders.h"

namespace murosimf::robot_formats::urdf {

class UrdfMeshPaths {
 public:
  /// `file`: the URDF file.
  UrdfMeshPaths(const std::filesystem::path& file, std::map<std::string, std::filesystem::path> packages,
                std::vector<std::filesystem::path> search_paths);

  /// Adds a folder for files that are not found otherwise, relative to the URDF file; with `strip`, for the last part
  /// of the name only. From the compiler options meshdir and strippath.
  void also_look_in(const std::filesystem::path& folder, bool strip);

  /// The file; nothing if there is no such file.
  [[nodiscard]] std::optional<std::filesystem::path> find(const std::string& name);

  /// What to do about a name that was not found, and the examined places.
  [[nodiscard]] std::string advice(const std::string& name) const;

 private:
  [[nodiscard]] std::optional<std::filesystem::path> find_anew(const std::string& name);
  [[nodiscard]] std::optional<std::filesystem::path> find_in_package(const std::string& package,
                                                                     const std::string& rest);
  [[nodiscard]] std::optional<std::filesystem::path> look(const std::filesystem::path& folder, const std::string& name);

  std::filesystem::path folder_;  ///< of the URDF file, absolute
  PackageFolders packages_;
  std::optional<std::filesystem::path> mesh_folder_;
  bool strip_ = false;
  std::vector<std::filesystem::path> looked_at_;                       ///< examined places of the last name
  std::map<std::string, std::optional<std::filesystem::path>> files_;  ///< found so far
};

}  // namespace murosimf::robot_formats::urdf
