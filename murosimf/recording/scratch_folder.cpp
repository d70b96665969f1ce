#include "murosimf/recording/scratch_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <ctime>
#include <string>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "murosimf/model/error.h"

namespace murosimf::recording {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view name_of_all = "murosimf_scratch.", six = "XXXXXX";
constexpr std::time_t young = 60;  // [s] a younger folder may not be locked yet

/// A descriptor that holds the lock; -1: it is held by another process, or not available.
int locked(const fs::path& folder) {
  const int file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (file >= 0 && ::flock(file, LOCK_EX | LOCK_NB) == 0) return file;
  if (file >= 0) ::close(file);
  return -1;
}

bool is_old_and_ours(int folder) {
  struct stat about {};
  return ::fstat(folder, &about) == 0 && about.st_uid == ::geteuid() && about.st_mtime + young < std::time(nullptr);
}

/// Folders of processes that were killed; those in use are locked.
void remove_left_ones(const fs::path& where) {
  std::error_code ignored;
  for (fs::directory_iterator all(where, ignored), end; !ignored && all != end; all.increment(ignored)) {
    const std::string name = all->path().filename().string();
    if (name.size() != name_of_all.size() + six.size() || !name.starts_with(name_of_all)) continue;
    const int lock = locked(all->path());
    if (lock < 0) continue;
    std::error_code unremovable;
    if (is_old_and_ours(lock)) fs::remove_all(all->path(), unremovable);
    ::close(lock);
  }
}

}  // namespace

/// The name is new: no other process can have prepared the folder.
ScratchFolder::ScratchFolder() {
  std::error_code error;
  const fs::path where = fs::temp_directory_path(error);
  std::string name = (where / fmt::format("{}{}", name_of_all, six)).string();
  if (!error) remove_left_ones(where);
  if (error || mkdtemp(name.data()) == nullptr) {
    throw SetupError(fmt::format("cannot make a folder for temporary files in '{}'", where.string()));
  }
  path_ = name;
  lock_ = locked(path_);
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
  if (lock_ >= 0) ::close(lock_);
}

}  // namespace murosimf::recording
