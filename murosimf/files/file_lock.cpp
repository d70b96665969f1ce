#include "murosimf/files/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <sstream>

#include <fmt/format.h>

namespace murosimf::files {
namespace {

struct flock whole_file() {
  struct flock lock {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  return lock;
}

/// From the kernel's list of locks; 0: it is not there.
long holder_in_list(int descriptor) {
  struct stat about {};
  if (::fstat(descriptor, &about) != 0) return 0;
  std::ifstream list("/proc/locks");
  for (std::string line; std::getline(list, line);) {
    // 1: FLOCK  ADVISORY  WRITE 4711 08:01:131 0 EOF
    std::istringstream words(line);
    std::string number, kind, advice, access, place;
    long process = 0;
    words >> number >> kind >> advice >> access >> process >> place;
    if (kind == "FLOCK" && place.ends_with(fmt::format(":{}", about.st_ino))) return process;
  }
  return 0;
}

std::string name_of_holder(int descriptor) {
  struct flock lock = whole_file();
  const bool told = ::fcntl(descriptor, F_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
  const long process = told ? lock.l_pid : holder_in_list(descriptor);  // its own fcntl() locks a process is not told
  return process > 0 ? fmt::format("process {}", process) : "another run";
}

}  // namespace

// Two kinds at once: flock() is of the open file, also within one process; fcntl() tells who has it.
bool lock_file(int descriptor) noexcept {
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) return false;
  struct flock lock = whole_file();
  (void)::fcntl(descriptor, F_SETLK, &lock);
  return true;
}

std::string who_writes(const std::filesystem::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return {};
  const bool is_held = ::flock(descriptor, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  const std::string holder = is_held ? name_of_holder(descriptor) : std::string{};
  ::close(descriptor);
  return holder;
}

}  // namespace murosimf::files
