/// urdf_mesh_path.h - finding the mesh files that a URDF file names.
///
/// Names are relative to the URDF file, absolute, file://..., or package://name/path (model:// means the same). A package
/// is looked for in this order: the package map; from the URDF file's folder upwards, a folder that is called so or
/// whose package.xml says so, or that has one called so; below the search paths in the same way; below the folders in
/// the environment variable MUROSIMF_PACKAGE_PATH (separated by colons).
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace murosimf::formats::urdf {

class UrdfMeshPaths {
 public:
  /// `file`: the URDF file.
  UrdfMeshPaths(const std::filesystem::path& file, std::map<std::string, std::filesystem::path> packages,
                std::vector<std::filesystem::path> search_paths);

  /// A folder to look in for what is not found otherwise, relative to the URDF file; with `strip`, for the last part
  /// of the name only. From the compiler options meshdir and strippath.
  void also_look_in(const std::filesystem::path& folder, bool strip);

  /// The file; nothing if there is no such file.
  [[nodiscard]] std::optional<std::filesystem::path> find(const std::string& name);

  /// What to do about a name that was not found.
  [[nodiscard]] static std::string advice(const std::string& name);

 private:
  [[nodiscard]] std::optional<std::filesystem::path> find_anew(const std::string& name);
  [[nodiscard]] std::optional<std::filesystem::path> find_in_package(const std::string& package,
                                                                     const std::filesystem::path& rest);
  /// Folders that may be the package, best first.
  [[nodiscard]] const std::vector<std::filesystem::path>& folders_of(const std::string& package);

  std::filesystem::path folder_;  ///< of the URDF file, absolute
  std::map<std::string, std::filesystem::path> packages_;
  std::vector<std::filesystem::path> search_paths_;
  std::optional<std::filesystem::path> mesh_folder_;
  bool strip_ = false;
  std::map<std::string, std::vector<std::filesystem::path>> package_folders_;  ///< found so far
  std::map<std::string, std::optional<std::filesystem::path>> files_;          ///< found so far
};

}  // namespace murosimf::formats::urdf
