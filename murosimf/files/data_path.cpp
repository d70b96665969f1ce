#include "murosimf/files/data_path.h"

#include <array>
#include <cstdlib>
#include <set>

#include <dlfcn.h>
#include <fmt/format.h>

#include "murosimf/files/file_access.h"
#include "murosimf/model/error.h"

namespace murosimf::files {
namespace {

namespace fs = std::filesystem;

std::optional<fs::path> look_for(std::string_view name, std::string_view kind, std::string_view extension,
                                 const fs::path& beside) {
  std::vector<fs::path> places{fs::path(name)};
  if (!beside.empty()) places.push_back(beside / name);
  for (const fs::path& root : data_folders()) {
    places.push_back(root / name);
    places.push_back(root / kind / name);
  }
  for (const fs::path& place : places) {
    for (const fs::path& candidate : {place, fs::path(place.string() + std::string(extension))}) {
      std::error_code error;
      // Limited files count as missing: see allowed_files.h.
      if (may_be_read(candidate) && fs::is_regular_file(candidate, error)) return candidate;
    }
  }
  return std::nullopt;
}

/// The shared library that contains this code; empty: it belongs to the program itself.
fs::path find_own_library() {
  static const int here = 0;
  Dl_info info{};
  std::error_code error;
  if (dladdr(&here, &info) == 0 || !info.dli_fname) return {};
  const fs::path file = fs::canonical(info.dli_fname, error);
  return error || file.string().find(".so") == std::string::npos ? fs::path() : file;
}

/// The same, found once: the search goes through all symbols of the program.
const fs::path& own_library() {
  static const fs::path library = find_own_library();
  return library;
}

}  // namespace

std::vector<fs::path> data_folders() {
  std::vector<fs::path> roots;
  if (const char* variable = std::getenv("MUROSIMF_DATA")) roots.emplace_back(variable);
  std::error_code error;
  if (const fs::path program = fs::read_symlink("/proc/self/exe", error); !error) {
    roots.push_back(program.parent_path().parent_path() / "share" / "murosimf");
  }
  if (const fs::path& library = own_library(); !library.empty()) {  // in lib/, or in lib/x86_64-linux-gnu/
    roots.push_back(library.parent_path() / "share" / "murosimf");  // a package of Python
    const fs::path folder = library.parent_path().parent_path();
    roots.push_back(folder / "share" / "murosimf");
    roots.push_back(folder.parent_path() / "share" / "murosimf");
  }
  roots.emplace_back(MUROSIMF_INSTALL_DATA_DIR);
  roots.emplace_back(MUROSIMF_SOURCE_DIR);
  return roots;
}

std::filesystem::path find_data_file(std::string_view name, std::string_view kind, std::string_view extension,
                                     const std::filesystem::path& beside) {
  if (const auto file = look_for_data_file(name, kind, extension, beside)) return *file;
  throw SetupError(fmt::format("no file '{}' or '{}{}' here or among the {} that come with the program", name, name,
                               extension, kind));
}

std::optional<std::filesystem::path> look_for_data_file(std::string_view name, std::string_view kind,
                                                        std::string_view extension,
                                                        const std::filesystem::path& beside) {
  if (const MovedFiles* moved = moved_files()) {
    const fs::path folder = beside.empty() ? beside : moved->to_there(fs::absolute(beside).lexically_normal());
    if (const std::string* found = moved->found(look_up_key(name, kind, extension, folder))) {
      const fs::path here = found->empty() ? fs::path{} : moved->to_here(*found);
      note_name_found(look_up_key(name, kind, extension, beside), here);
      return here.empty() || !may_be_read(here) ? std::nullopt : std::optional(here);
    }
  }
  const std::optional<fs::path> found = look_for(name, kind, extension, beside);
  note_name_found(look_up_key(name, kind, extension, beside), found.value_or(fs::path{}));
  return found;
}

std::vector<std::filesystem::path> program_folders() {
  constexpr std::array kinds{"buses", "examples", "lenses", "models", "motions", "parts", "scenes", "servos"};
  std::vector<fs::path> folders;
  for (const fs::path& root : data_folders()) {
    for (const char* kind : kinds) folders.push_back(root / kind);
  }
  return folders;
}

std::vector<std::string> data_file_names(std::string_view kind, std::string_view extension) {
  std::set<std::string> names;
  for (const fs::path& root : data_folders()) {
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(root / kind, error)) {
      if (entry.path().extension() == extension) names.insert(entry.path().stem().string());
    }
  }
  return {names.begin(), names.end()};
}

}  // namespace murosimf::files
