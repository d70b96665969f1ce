#include "murosimf/files/files_read.h"

#include <algorithm>

namespace murosimf::files {

void FilesRead::note(const std::filesystem::path& file) {
  if (std::ranges::find(list_, file) == list_.end()) list_.push_back(file);
}

void FilesRead::note_name(const std::string& key, const std::filesystem::path& file) {
  names_[key] = file.empty() ? "" : std::filesystem::absolute(file).lexically_normal().string();
}

}  // namespace murosimf::files
