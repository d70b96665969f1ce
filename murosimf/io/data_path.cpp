#include "murosimf/io/data_path.h"

#include <cstdlib>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "murosimf/model/error.h"

namespace murosimf::io {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> data_roots() {
  std::vector<fs::path> roots;
  if (const char* variable = std::getenv("MUROSIMF_DATA")) roots.emplace_back(variable);
  std::error_code error;
  if (const fs::path program = fs::read_symlink("/proc/self/exe", error); !error) {
    roots.push_back(program.parent_path().parent_path() / "share" / "murosimf");
  }
  roots.emplace_back(MUROSIMF_INSTALL_DATA_DIR);
  roots.emplace_back(MUROSIMF_SOURCE_DIR);
  return roots;
}

}  // namespace

std::filesystem::path find_data_file(std::string_view name, std::string_view kind, std::string_view extension,
                                     const std::filesystem::path& beside) {
  std::vector<fs::path> places{fs::path(name)};
  if (!beside.empty()) places.push_back(beside / name);
  for (const fs::path& root : data_roots()) {
    places.push_back(root / name);
    places.push_back(root / kind / name);
  }
  for (const fs::path& place : places) {
    for (const fs::path& candidate : {place, fs::path(place.string() + std::string(extension))}) {
      std::error_code error;
      if (fs::is_regular_file(candidate, error)) return candidate;
    }
  }
  throw SetupError(fmt::format("no file '{}' or '{}{}' here or among the {} that come with the program", name, name,
                               extension, kind));
}

}  // namespace murosimf::io
