#include "murosimf/robot_formats/sdf/sdf_include.h"

#include <algorithm>
#include <string_view>

#include "murosimf/files/file_access.h"
#include "murosimf/files/file_spelling.h"
#include "murosimf/files/xml_element.h"
#include "murosimf/model/error.h"
#include "murosimf/robot_formats/urdf/package_folders.h"

namespace murosimf::robot_formats::sdf {
namespace {

namespace fs = std::filesystem;

fs::path folder_of(const fs::path& file) { return fs::absolute(file).lexically_normal().parent_path(); }

bool is_file(const fs::path& path) {
  std::error_code error;
  return files::may_be_read(path) && fs::is_regular_file(path, error);
}

/// The model file of the newest version in a `model.config`.
std::optional<fs::path> configured_file(const fs::path& folder) {
  const files::XmlFile config(folder / "model.config");
  std::optional<fs::path> best;
  double newest = -1;
  for (const files::XmlElement& sdf : config.root().children("sdf")) {
    const auto version = files::parse_numbers(sdf.attribute("version").value_or("0"));
    // Versions are compared as numbers, as Gazebo does: 1.10 counts as 1.1.
    const double number = version && version->size() == 1 ? version->front() : 0;
    if (number <= newest || sdf.text().empty()) continue;
    newest = number;
    best = folder / sdf.text();
  }
  return best;
}

}  // namespace

std::vector<fs::path> include_places(const std::string& uri, const fs::path& from,
                                     const robot_formats::ReaderOptions& options) {
  std::vector<fs::path> places;
  urdf::PackageFolders packages(folder_of(from), options.packages, options.search_paths);
  for (const std::string_view scheme : {"model", "package"}) {
    const auto rest = files::after_scheme(uri, scheme);
    if (!rest) continue;
    const std::size_t slash = std::min(rest->find('/'), rest->size());
    const std::string inside = slash < rest->size() ? rest->substr(slash + 1) : "";
    // A package can be in several folders; all of them are tried in their order.
    for (const fs::path& folder : packages.folders_of(rest->substr(0, slash))) {
      places.push_back(inside.empty() ? folder : folder / inside);
    }
    return places;
  }
  const std::string path = files::path_of_address(uri).value_or(uri);
  places.push_back(folder_of(from) / path);
  for (const fs::path& folder : packages.search_paths()) places.push_back(folder / path);
  return places;
}

std::optional<fs::path> model_file(const fs::path& place) {
  if (is_file(place)) return place;
  if (is_file(place / "model.config")) {
    if (const auto file = configured_file(place); file && is_file(*file)) return file;
  }
  if (is_file(place / "model.sdf")) return place / "model.sdf";
  return std::nullopt;
}

}  // namespace murosimf::robot_formats::sdf
