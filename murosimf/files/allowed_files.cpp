#include "murosimf/files/allowed_files.h"

#include <algorithm>
#include <system_error>

#include "murosimf/math/assert.h"

namespace murosimf::files {
namespace {

namespace fs = std::filesystem;

/// Without looking at the disk; empty if it has no name.
fs::path named(const fs::path& path) {
  std::error_code error;
  return path.empty() ? fs::path{} : fs::absolute(path, error).lexically_normal();
}

/// The path behind links and `..`; empty if it cannot be determined.
fs::path real(const fs::path& path) {
  std::error_code error;
  const fs::path found = fs::weakly_canonical(path, error);
  return error ? fs::path{} : found;
}

bool is_hidden(const fs::path& part) { return part.native().starts_with('.'); }

/// Whether the path is below the folder and not hidden; `path` and `folder` are absolute and normal.
bool is_inside(const fs::path& path, const fs::path& folder) {
  const fs::path below = path.lexically_relative(folder);
  return !below.empty() && below != "." && std::ranges::none_of(below, is_hidden);
}

bool is_in_any(const fs::path& path, const std::vector<fs::path>& folders, const std::vector<fs::path>& files) {
  const auto holds = [&](const fs::path& folder) { return is_inside(path, folder); };
  return std::ranges::find(files, path) != files.end() || std::ranges::any_of(folders, holds);
}

/// Removes the slash at the end of a folder's name, which would be a part of its own.
fs::path without_slash(const fs::path& folder) { return folder.has_filename() ? folder : folder.parent_path(); }

bool has_control_characters(const fs::path& path) {
  return std::ranges::any_of(path.native(), [](unsigned char c) { return c < ' ' || c == 0x7f; });
}

}  // namespace

AllowedFiles::AllowedFiles(const std::vector<fs::path>& folders, const std::vector<fs::path>& files) {
  std::error_code error;
  for (const fs::path& folder : folders) {
    if (!fs::is_directory(folder, error)) continue;
    const fs::path there = real(folder);
    MUROSIMF_ASSERT(there.empty() || there.is_absolute());
    folders_.push_back(without_slash(there));
    named_folders_.push_back(without_slash(named(folder)));
    named_folders_.push_back(without_slash(there));
  }
  for (const fs::path& file : files) {
    if (!fs::is_regular_file(file, error)) continue;
    files_.push_back(real(file));
    named_files_.push_back(named(file));
    named_files_.push_back(files_.back());
    MUROSIMF_ASSERT(named_files_.size() == 2 * files_.size());
  }
}

bool AllowedFiles::allows(const fs::path& file) const {
  if (file.empty() || has_control_characters(file)) return false;
  // First by name: a file outside is not looked for, so that the answer does not reveal whether it exists.
  if (!is_in_any(named(file), named_folders_, named_files_)) return false;
  return is_in_any(real(file), folders_, files_);
}

}  // namespace murosimf::files
