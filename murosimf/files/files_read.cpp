#include "murosimf/files/files_read.h"

#include <algorithm>
#include <cassert>

namespace murosimf::files {
namespace {

thread_local FilesRead* listener = nullptr;

}  // namespace

FilesRead::FilesRead() {
  assert(!listener && "two lists of files in one thread");
  listener = this;
}

FilesRead::~FilesRead() { listener = nullptr; }

void note_file_read(const std::filesystem::path& file) {
  if (!listener) return;
  auto& list = listener->list_;
  if (std::ranges::find(list, file) == list.end()) list.push_back(file);
}

}  // namespace murosimf::files
