#include "murosimf/files/files_read.h"

#include <algorithm>

#include "murosimf/math/assert.h"

namespace murosimf::files {
namespace {

thread_local FilesRead* listener = nullptr;

}  // namespace

FilesRead::FilesRead() {
  MUROSIMF_ASSERT(!listener && "two lists of files in one thread");
  listener = this;
}

FilesRead::~FilesRead() { stop(); }

void FilesRead::stop() {
  if (listener == this) listener = nullptr;
}

void note_file_read(const std::filesystem::path& file) {
  if (!listener) return;
  auto& list = listener->list_;
  if (std::ranges::find(list, file) == list.end()) list.push_back(file);
}

void note_name_found(const std::string& key, const std::filesystem::path& file) {
  if (!listener) return;
  listener->names_[key] = file.empty() ? "" : std::filesystem::absolute(file).lexically_normal().string();
}

}  // namespace murosimf::files
