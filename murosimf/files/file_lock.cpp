#include "murosimf/files/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <sstream>

#include <fmt/format.h>

#include "murosimf/math/assert.h"

namespace murosimf::files {
namespace {

struct flock whole_file() {
  struct flock lock {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  return lock;
}

/// The process that holds the lock, from the kernel's list of locks; 0: it is not there.
long holder_in_list(int descriptor) {
  MUROSIMF_ASSERT(descriptor >= 0);
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
  // The kernel does not report a process' own fcntl() locks to it: these are in the list.
  const bool told = ::fcntl(descriptor, F_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
  const long process = told ? lock.l_pid : holder_in_list(descriptor);
  return process > 0 ? fmt::format("process {}", process) : "another run";
}

}  // namespace

// Two kinds at once: flock() belongs to the open file, also within one process; fcntl() reports the process that holds it.
bool lock_file(int descriptor) noexcept {
  MUROSIMF_ASSERT(descriptor >= 0);
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
