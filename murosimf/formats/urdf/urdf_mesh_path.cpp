#include "murosimf/formats/urdf/urdf_mesh_path.h"

#include <cstdlib>
#include <sstream>
#include <string_view>

#include <fmt/format.h>

#include "murosimf/files/xml_element.h"
#include "murosimf/model/error.h"

namespace murosimf::formats::urdf {
namespace {

namespace fs = std::filesystem;

bool is_file(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

bool is_folder(const fs::path& path) {
  std::error_code error;
  return fs::is_directory(path, error);
}

/// The name that a folder's package.xml gives; empty without one.
std::string package_name(const fs::path& folder) {
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

void add_if_package(const fs::path& folder, const std::string& name, std::vector<fs::path>& folders) {
  if (folder.filename() == name || package_name(folder) == name) folders.push_back(folder);
  if (is_folder(folder / name)) folders.push_back(folder / name);
}

std::vector<fs::path> folders_of_environment() {
  std::vector<fs::path> folders;
  const char* variable = std::getenv("MUROSIMF_PACKAGE_PATH");
  std::istringstream stream(variable ? variable : "");
  for (std::string folder; std::getline(stream, folder, ':');) {
    if (!folder.empty()) folders.emplace_back(folder);
  }
  return folders;
}

/// What follows `prefix` in `name`.
std::optional<std::string> after(std::string_view name, std::string_view prefix) {
  if (!name.starts_with(prefix)) return std::nullopt;
  return std::string(name.substr(prefix.size()));
}

std::optional<std::string> package_part(const std::string& name) {
  const auto rest = after(name, "package://");
  return rest ? rest : after(name, "model://");
}

}  // namespace

UrdfMeshPaths::UrdfMeshPaths(const fs::path& file, std::map<std::string, fs::path> packages,
                             std::vector<fs::path> search_paths)
    : folder_(fs::absolute(file).lexically_normal().parent_path()),
      packages_(std::move(packages)),
      search_paths_(std::move(search_paths)) {
  for (fs::path& folder : folders_of_environment()) search_paths_.push_back(std::move(folder));
}

void UrdfMeshPaths::also_look_in(const fs::path& folder, bool strip) {
  mesh_folder_ = folder_ / folder;
  strip_ = strip;
}

std::optional<fs::path> UrdfMeshPaths::find(const std::string& name) {
  if (const auto known = files_.find(name); known != files_.end()) return known->second;
  auto file = find_anew(name);
  if (!file && mesh_folder_) {
    const fs::path part = package_part(name).value_or(name);
    const fs::path candidate = *mesh_folder_ / (strip_ ? part.filename() : part);
    if (is_file(candidate)) file = candidate;
  }
  if (file) file = file->lexically_normal();
  return files_.emplace(name, file).first->second;
}

std::optional<fs::path> UrdfMeshPaths::find_anew(const std::string& name) {
  if (const auto rest = package_part(name)) {
    const std::size_t slash = rest->find('/');
    if (slash == std::string::npos) return std::nullopt;
    return find_in_package(rest->substr(0, slash), rest->substr(slash + 1));
  }
  const fs::path path = folder_ / after(name, "file://").value_or(name);
  if (is_file(path)) return path;
  for (const fs::path& folder : search_paths_) {
    if (is_file(folder / name)) return folder / name;
  }
  return std::nullopt;
}

std::optional<fs::path> UrdfMeshPaths::find_in_package(const std::string& package, const fs::path& rest) {
  for (const fs::path& folder : folders_of(package)) {
    if (is_file(folder / rest)) return folder / rest;
  }
  return std::nullopt;
}

const std::vector<fs::path>& UrdfMeshPaths::folders_of(const std::string& package) {
  const auto [entry, is_new] = package_folders_.try_emplace(package);
  auto& folders = entry->second;
  if (!is_new) return folders;
  if (const auto mapped = packages_.find(package); mapped != packages_.end()) folders.push_back(mapped->second);
  for (fs::path folder = folder_;; folder = folder.parent_path()) {
    add_if_package(folder, package, folders);
    if (folder == folder.parent_path()) break;
  }
  for (const fs::path& folder : search_paths_) add_if_package(folder, package, folders);
  return folders;
}

std::string UrdfMeshPaths::advice(const std::string& name) {
  if (const auto rest = package_part(name)) {
    return fmt::format("put the folder of package '{}' above the file or into MUROSIMF_PACKAGE_PATH",
                       rest->substr(0, rest->find('/')));
  }
  return "names are relative to the URDF file; correct the name, or put its folder into MUROSIMF_PACKAGE_PATH";
}

}  // namespace murosimf::formats::urdf
