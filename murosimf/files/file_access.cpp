#include "murosimf/files/file_access.h"

#include <atomic>
#include <utility>

namespace murosimf::files {

struct FileScope::Level {
  FileAccess access;
  std::shared_ptr<Level> outer;
  std::atomic<bool> ended = false;  // possibly in another thread
};

namespace {

thread_local std::shared_ptr<FileScope::Level> innermost;

void leave_ended() noexcept {
  while (innermost && innermost->ended) innermost = std::shared_ptr(innermost->outer);
}

/// What the innermost scope that has it says; null: none has.
template <class Part>
Part* in_force(std::shared_ptr<Part> FileAccess::*part) noexcept {
  for (const FileScope::Level* level = innermost.get(); level; level = level->outer.get()) {
    if (!level->ended && level->access.*part) return (level->access.*part).get();
  }
  return nullptr;
}

}  // namespace

FileScope::FileScope(FileAccess access) : level_(std::make_shared<Level>()) {
  leave_ended();
  level_->access = std::move(access);
  level_->outer = innermost;
  innermost = level_;
}

void FileScope::end() noexcept {
  level_->ended = true;
  leave_ended();
}

bool may_be_read(const std::filesystem::path& file) {
  const AllowedFiles* const allowed = in_force(&FileAccess::only_from);
  return !allowed || allowed->allows(file);
}

bool reads_are_limited() noexcept { return in_force(&FileAccess::only_from) != nullptr; }

const MovedFiles* moved_files() noexcept { return in_force(&FileAccess::moved); }

void note_file_read(const std::filesystem::path& file) {
  if (FilesRead* const noted = in_force(&FileAccess::noted)) noted->note(file);
}

void note_name_found(const std::string& key, const std::filesystem::path& file) {
  if (FilesRead* const noted = in_force(&FileAccess::noted)) noted->note_name(key, file);
}

}  // namespace murosimf::files
