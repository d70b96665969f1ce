#include "murosimf/robot_formats/urdf/package_folders.h"

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <utility>

#include "murosimf/files/xml_element.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::robot_formats::urdf {
namespace {

namespace fs = std::filesystem;
using Folders = std::vector<fs::path>;

constexpr int deepest_package = 5;           // folders below one of ROS_PACKAGE_PATH
constexpr std::size_t most_folders = 20000;  // examined below it: a search path may be a whole disk

bool is_folder(const fs::path& path) {
  std::error_code error;
  return fs::is_directory(path, error);
}

bool is_file(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

/// The name that a folder's package.xml gives; empty without one.
std::string declared_name(const fs::path& folder) {
  const fs::path file = folder / "package.xml";
  if (!is_file(file)) return {};
  try {
    const files::XmlFile xml(file);
    const auto names = xml.root().children("name");
    return names.empty() ? "" : names[0].text();
  } catch (const SetupError&) {
    return {};  // a broken file names no package
  }
}

void add_if_package(const fs::path& folder, const std::string& name, Folders& folders) {
  if (folder.filename() == name || declared_name(folder) == name) folders.push_back(folder);
  if (is_folder(folder / name)) folders.push_back(folder / name);
}

/// Folders of an environment variable, separated by colons.
Folders folders_of_variable(const char* variable) {
  Folders folders;
  const char* text = std::getenv(variable);
  std::istringstream stream(text ? text : "");
  for (std::string folder; std::getline(stream, folder, ':');) {
    if (!folder.empty()) folders.emplace_back(folder);
  }
  return folders;
}

Folders subfolders(const fs::path& folder) {
  Folders found;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, fs::directory_options::skip_permission_denied, error)) {
    if (!entry.path().filename().string().starts_with('.') && is_folder(entry.path())) found.push_back(entry.path());
  }
  std::ranges::sort(found);  // directories list in any order: the same package must be found on every machine
  return found;
}

/// Finds packages of the name below `folder`; a package contains no packages.
void crawl(const fs::path& folder, const std::string& name, int depth, std::size_t& rest, Folders& folders) {
  MUROSIMF_ASSERT(depth >= 0);
  if (rest == 0) return;
  --rest;
  if (is_file(folder / "package.xml")) {
    if (declared_name(folder) == name) folders.push_back(folder);
    return;
  }
  if (folder.filename() == name) folders.push_back(folder);
  if (depth == 0) return;
  for (const fs::path& inside : subfolders(folder)) crawl(inside, name, depth - 1, rest, folders);
}

void add_folders_of_others(const std::string& name, Folders& folders) {
  for (const char* variable : {"AMENT_PREFIX_PATH", "COLCON_PREFIX_PATH", "CMAKE_PREFIX_PATH"}) {
    for (const fs::path& prefix : folders_of_variable(variable)) {
      for (fs::path folder : {prefix / "share" / name, prefix / name / "share" / name}) {
        if (is_folder(folder)) folders.push_back(std::move(folder));
      }
    }
  }
  for (const char* variable : {"GAZEBO_MODEL_PATH", "GZ_SIM_RESOURCE_PATH", "IGN_GAZEBO_RESOURCE_PATH"}) {
    for (const fs::path& folder : folders_of_variable(variable)) {
      if (is_folder(folder / name)) folders.push_back(folder / name);
    }
  }
  for (const fs::path& folder : folders_of_variable("ROS_PACKAGE_PATH")) {
    std::size_t rest = most_folders;
    crawl(folder, name, deepest_package, rest, folders);
  }
}

}  // namespace

PackageFolders::PackageFolders(fs::path folder, std::map<std::string, fs::path> packages, Folders search_paths)
    : folder_(std::move(folder)), packages_(std::move(packages)), search_paths_(std::move(search_paths)) {
  for (fs::path& more : folders_of_variable("MUROSIMF_PACKAGE_PATH")) search_paths_.push_back(std::move(more));
}

const Folders& PackageFolders::folders_of(const std::string& package) {
  const auto [entry, is_new] = found_.try_emplace(package);
  Folders& folders = entry->second;
  if (!is_new || package.empty()) return folders;
  // The user's own map first, then nearby folders, then those of other programs.
  if (const auto mapped = packages_.find(package); mapped != packages_.end()) folders.push_back(mapped->second);
  for (fs::path folder = folder_;; folder = folder.parent_path()) {
    add_if_package(folder, package, folders);
    if (folder == folder.parent_path()) break;
  }
  for (const fs::path& folder : search_paths_) add_if_package(folder, package, folders);
  add_folders_of_others(package, folders);
  return folders;
}

}  // namespace murosimf::robot_formats::urdf
