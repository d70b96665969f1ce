#include "murosimf/robot_formats/urdf/urdf_mesh_path.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "murosimf/files/file_spelling.h"
#include "murosimf/math/assert.h"

namespace murosimf::robot_formats::urdf {
namespace {

namespace fs = std::filesystem;

/// A name in a package: "pkg" and "meshes/a.stl" of package://pkg/meshes/a.stl.
struct PackageName {
  std::string package, rest;
};

PackageName split(std::string name) {
  const std::size_t first = std::min(name.find_first_not_of("/\\"), name.size());
  MUROSIMF_ASSERT(first <= name.size());
  name.erase(0, first);
  const std::size_t slash = std::min(name.find_first_of("/\\"), name.size());
  return {name.substr(0, slash), slash < name.size() ? name.substr(slash + 1) : ""};
}

/// Splits "$(find pkg)/a.stl", a macro of launch files.
std::optional<PackageName> of_find(std::string_view name) {
  for (const std::string_view begin : {"$(find ", "$(find-pkg-share "}) {
    const std::size_t end = name.find(')');
    if (!name.starts_with(begin) || end == std::string_view::npos) continue;
    return split(fmt::format("{}{}", name.substr(begin.size(), end - begin.size()), name.substr(end + 1)));
  }
  return std::nullopt;
}

std::optional<PackageName> package_name(const std::string& name) {
  for (const std::string_view scheme : {"package", "model"}) {
    if (auto rest = files::after_scheme(name, scheme)) return split(*std::move(rest));
  }
  return of_find(name);
}

bool is_web_address(const std::string& name) {
  return files::after_scheme(name, "http") || files::after_scheme(name, "https");
}

/// The first three of the paths, for a message.
std::string list_of(const std::vector<fs::path>& paths) {
  constexpr std::size_t most = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(paths.size(), most); ++i) {
    text += fmt::format("{}{}", i > 0 ? ", " : "", paths[i].lexically_normal().string());
  }
  return paths.size() > most ? fmt::format("{} and {} more", text, paths.size() - most) : text;
}

}  // namespace

UrdfMeshPaths::UrdfMeshPaths(const fs::path& file, std::map<std::string, fs::path> packages,
                             std::vector<fs::path> search_paths)
    : folder_(fs::absolute(file).lexically_normal().parent_path()),
      packages_(folder_, std::move(packages), std::move(search_paths)) {}

void UrdfMeshPaths::also_look_in(const fs::path& folder, bool strip) {
  mesh_folder_ = folder_ / folder;
  strip_ = strip;
}

std::optional<fs::path> UrdfMeshPaths::find(const std::string& name) {
  if (const auto known = files_.find(name); known != files_.end() && known->second) return known->second;
  looked_at_.clear();
  auto file = find_anew(name);
  // Last, as MuJoCo does it: the folder of the compiler's options, with or without the folders of the name.
  if (!file && mesh_folder_) {
    const auto of_package = package_name(name);
    const fs::path part = of_package ? fs::path(of_package->package) / of_package->rest : fs::path(name);
    file = look(*mesh_folder_, (strip_ ? part.filename() : part).string());
  }
  if (file) file = file->lexically_normal();
  return files_.insert_or_assign(name, file).first->second;
}

std::optional<fs::path> UrdfMeshPaths::look(const fs::path& folder, const std::string& name) {
  looked_at_.push_back(folder / name);
  return files::find_spelled(folder, name);
}

std::optional<fs::path> UrdfMeshPaths::find_anew(const std::string& name) {
  if (const auto by_package = package_name(name)) return find_in_package(by_package->package, by_package->rest);
  const std::string path = files::path_of_address(name).value_or(name);
  if (auto file = look(folder_, path)) return file;
  for (const fs::path& folder : packages_.search_paths()) {
    if (auto file = look(folder, path)) return file;
  }
  return std::nullopt;
}

std::optional<fs::path> UrdfMeshPaths::find_in_package(const std::string& package, const std::string& rest) {
  for (const fs::path& folder : packages_.folders_of(package)) {
    if (auto file = look(folder, rest)) return file;
  }
  // A package name with escapes is tried as it is first: a folder may have such a name.
  const std::string decoded = files::percent_decoded(package);
  return decoded == package ? std::nullopt : find_in_package(decoded, rest);
}

std::string UrdfMeshPaths::advice(const std::string& name) const {
  if (is_web_address(name)) return "it is an address in the web; download it, and write the name of the file";
  const std::string looked = looked_at_.empty() ? "" : fmt::format(" (not there: {})", list_of(looked_at_));
  if (const auto by_package = package_name(name)) {
    return fmt::format("put the folder of package '{}' above the file or into MUROSIMF_PACKAGE_PATH{}",
                       by_package->package, looked);
  }
  return "names are relative to the URDF file; correct the name, or put its folder into MUROSIMF_PACKAGE_PATH" + looked;
}

}  // namespace murosimf::robot_formats::urdf
