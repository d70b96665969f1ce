/// package_folders.h - finds the packages of names like package://name/path.
///
/// In this order: the package map; from the URDF file's folder upwards, a folder with that name or with the name in its package.xml, or
/// one that has such a subfolder; below the search paths in the same way; below the folders in the environment variable MUROSIMF_PACKAGE_PATH
/// (separated by colons); then the folders of other programs:
///
///     ROS_PACKAGE_PATH                                  folders with the name in package.xml, down to the fifth level below each
///     AMENT_PREFIX_PATH, COLCON_PREFIX_PATH, CMAKE_PREFIX_PATH      PREFIX/share/NAME, PREFIX/NAME/share/NAME
///     GAZEBO_MODEL_PATH, GZ_SIM_RESOURCE_PATH, IGN_GAZEBO_RESOURCE_PATH      FOLDER/NAME
///
/// Sources: documentation of rospack, "ROS_PACKAGE_PATH"; of ament, colcon and Gazebo, environment variables.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace murosimf::robot_formats::urdf {

class PackageFolders {
 public:
  /// `folder`: of the URDF file, absolute.
  PackageFolders(std::filesystem::path folder, std::map<std::string, std::filesystem::path> packages,
                 std::vector<std::filesystem::path> search_paths);

  /// Folders that may be the package, best first; they need not exist.
  [[nodiscard]] const std::vector<std::filesystem::path>& folders_of(const std::string& package);

  /// The given search paths, then those of MUROSIMF_PACKAGE_PATH.
  [[nodiscard]] const std::vector<std::filesystem::path>& search_paths() const { return search_paths_; }

 private:
  std::filesystem::path folder_;
  std::map<std::string, std::filesystem::path> packages_;
  std::vector<std::filesystem::path> search_paths_;
  std::map<std::string, std::vector<std::filesystem::path>> found_;  ///< so far
};

}  // namespace murosimf::robot_formats::urdf
