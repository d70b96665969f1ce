#include "murosimf/recording/mcap/growing_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "murosimf/files/file_lock.h"
#include "murosimf/files/file_roles.h"
#include "murosimf/files/output_file.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/recording/mcap/crc32.h"

namespace murosimf::recording {
namespace {

namespace fs = std::filesystem;

fs::path part_beside(const fs::path& file) { return file.string() + ".part"; }

/// Whether the name still denotes the open file.
bool is_at(int descriptor, const fs::path& path) {
  struct stat open_one {};
  struct stat named {};
  return ::fstat(descriptor, &open_one) == 0 && ::stat(path.c_str(), &named) == 0 && open_one.st_ino == named.st_ino &&
         open_one.st_dev == named.st_dev;
}

std::uint64_t size_of(int descriptor) {
  struct stat about {};
  return ::fstat(descriptor, &about) == 0 ? static_cast<std::uint64_t>(about.st_size) : 0;
}

/// Renames a file, unless the new name exists. Returns 0, or errno: EEXIST if it exists.
int rename_to_free(const fs::path& from, const fs::path& to) {
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return 0;
  if (errno != EINVAL && errno != ENOSYS) return errno;
  // the file system does not support it: check and rename, with a small gap
  if (::access(to.c_str(), F_OK) == 0) return EEXIST;
  return ::rename(from.c_str(), to.c_str()) == 0 ? 0 : errno;
}

}  // namespace

/// A regular file is written beside its place and replaces it at the end; devices and pipes are written directly.
GrowingFile::GrowingFile(const fs::path& file) : file_(file), place_(file) {
  files::check_writable(file);
  if (place_.is_replaced()) {
    part_ = part_beside(place_.path());
    open_part();
  } else {
    open_directly();
  }
}

GrowingFile::~GrowingFile() {
  const fs::path& here = begun_ ? at_ : part_;
  const bool is_empty = place_.is_replaced() && descriptor_ >= 0 && size_of(descriptor_) == 0;
  if (is_empty && is_at(descriptor_, here)) ::unlink(here.c_str());
  if (descriptor_ >= 0) ::close(descriptor_);
}

/// The place may be a descriptor of this process, like /dev/stdout.
void GrowingFile::open_directly() {
  descriptor_ = place_.descriptor() >= 0 ? ::fcntl(place_.descriptor(), F_DUPFD_CLOEXEC, 0)
                                         : ::open(place_.path().c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor_ < 0) refuse(errno);
  (void)std::fflush(nullptr);
  at_ = file_;
  begun_ = true;
}

/// Opens the part, which may be of a run that was killed, and locks it. Another run may rename or remove it at the same time: retried then.
void GrowingFile::open_part() {
  for (;;) {
    descriptor_ = ::open(part_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor_ < 0) refuse(errno);
    const bool locked = files::lock_file(descriptor_);
    if (locked && is_at(descriptor_, part_)) break;
    const std::string holder = locked ? "" : files::who_writes(part_);
    ::close(std::exchange(descriptor_, -1));
    if (!holder.empty()) refuse("it is being written by " + holder);
  }
  if (size_of(descriptor_) == 0) empty_part_.emplace(part_);
  // the previous holder of the lock may be writing under the name itself now
  if (const std::string holder = files::who_writes(place_.path()); !holder.empty()) {
    if (empty_part_) ::unlink(part_.c_str());
    ::close(std::exchange(descriptor_, -1));
    refuse("it is being written by " + holder);
  }
}

void GrowingFile::begin() {
  if (begun_) return;
  if (failed_) refuse(EIO);
  failed_ = true;  // until it succeeds
  files::check_not_input(place_.path());
  if (size_of(descriptor_) > 0) put_aside();
  take_name();
  empty_part_.reset();
  begun_ = true;
  failed_ = false;
  write(std::exchange(pending_, {}));
  MUROSIMF_ASSERT(written_ == size_);
}

/// Moves a file that another run has left to a free name: game.cut_off_1.mcap.
void GrowingFile::put_aside() {
  const fs::path& place = place_.path();
  for (int i = 1;; ++i) {
    aside_ = place.parent_path() / fmt::format("{}.cut_off_{}{}", place.stem().string(), i, place.extension().string());
    const int failure = rename_to_free(part_, aside_);
    if (failure == 0) break;
    if (failure != EEXIST) refuse(failure);
  }
  ::close(std::exchange(descriptor_, -1));
  open_part();
}

void GrowingFile::take_name() {
  const int failure = rename_to_free(part_, place_.path());
  if (failure != 0 && failure != EEXIST) refuse(failure);
  at_ = failure == 0 ? place_.path() : part_;
}

/// Before the file begins, its bytes stay in memory: a run that fails at its start leaves no file.
void GrowingFile::append(std::string_view bytes) {
  if (failed_) refuse(EIO);
  if (begun_) {
    write(bytes);
  } else {
    pending_ += bytes;
  }
  size_ += bytes.size();
  MUROSIMF_ASSERT(!begun_ || written_ == size_);
  crc_ = crc32(bytes, crc_);
}

void GrowingFile::write(std::string_view bytes) {
  MUROSIMF_ASSERT(descriptor_ >= 0 && !complete_);
  for (std::string_view left = bytes; !left.empty();) {
    const ssize_t count = ::write(descriptor_, left.data(), left.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) {
      const int error = count < 0 ? errno : EIO;
      // a partial record would make the complete ones unreadable, so it is cut off; devices have no length
      if (place_.is_replaced() && ::ftruncate(descriptor_, static_cast<off_t>(written_)) == 0) {
        (void)::lseek(descriptor_, static_cast<off_t>(written_), SEEK_SET);
      }
      refuse(error);
    }
    left.remove_prefix(static_cast<std::size_t>(count));
  }
  written_ += bytes.size();
}

void GrowingFile::sync() {
  if (begun_ && !complete_ && ::fdatasync(descriptor_) != 0 && errno != EINVAL)
    refuse(errno);  // EINVAL: a device without a buffer
}

void GrowingFile::finish() {
  if (complete_) return;
  begin();
  sync();
  if (at_ == part_ && !part_.empty()) replace_older();
  complete_ = true;
  if (size_ > 0) ::close(std::exchange(descriptor_, -1));  // an empty one is removed with its writer
}

/// The place is checked again: another program may have begun to write it meanwhile.
void GrowingFile::replace_older() {
  files::check_not_input(place_.path());
  if (const std::string holder = files::who_writes(place_.path()); !holder.empty()) {
    refuse(fmt::format("it is being written by {}; this one is in '{}'", holder, part_.string()));
  }
  struct stat before {};
  if (::stat(place_.path().c_str(), &before) == 0) (void)::fchmod(descriptor_, before.st_mode & 07777);
  if (::rename(part_.c_str(), place_.path().c_str()) != 0) refuse(errno);
  at_ = place_.path();
}

void GrowingFile::refuse(int error) const { refuse(std::generic_category().message(error)); }

void GrowingFile::refuse(const std::string& reason) const {
  throw SetupError(fmt::format("cannot write '{}': {}", file_.string(), reason));
}

/// Why there is no whole file: it is still being written, or a part is left of a run that was killed.
std::string part_diagnostic(const fs::path& file) {
  const fs::path place = files::OutputPlace(file).path(), part = part_beside(place);
  for (const fs::path& one : {place, part}) {
    if (const std::string holder = files::who_writes(one); !holder.empty()) {
      return fmt::format("{} writes '{}' now", holder, one.string());
    }
  }
  std::error_code error;
  const auto size = fs::file_size(part, error);
  if (error || size == 0) return {};
  return fmt::format("'{}' is of a run that did not come to its end; 'murosimf repair' makes it whole, too",
                     part.string());
}

}  // namespace murosimf::recording
