#include "murosimf/files/output_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "murosimf/files/file_lock.h"
#include "murosimf/files/file_roles.h"
#include "murosimf/files/output_place.h"
#include "murosimf/files/xml_element.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::files {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& file, const std::string& reason) {
  throw SetupError(one_line(fmt::format("cannot write '{}': {}", file.string(), reason)));
}

[[noreturn]] void refuse(const fs::path& file, int error) { refuse(file, std::generic_category().message(error)); }

/// The process number in the name keeps two runs that write the same file apart.
fs::path part_of(const fs::path& place, PartFile::Extension extension) {
  if (extension == PartFile::Extension::part) return place.string() + fmt::format(".{}.part", ::getpid());
  return place.parent_path() /
         fmt::format(".{}.{}.part{}", place.stem().string(), ::getpid(), place.extension().string());
}

void check_place(const fs::path& file, const OutputPlace& place) {
  std::error_code error;
  if (place.descriptor() >= 0) {
    const int flags = ::fcntl(place.descriptor(), F_GETFL);
    if (flags < 0) refuse(file, errno);
    if ((flags & O_ACCMODE) == O_RDONLY) refuse(file, EBADF);
    return;
  }
  if (fs::is_directory(place.path(), error)) refuse(file, "it is a folder");
  const fs::path folder = place.path().parent_path();
  if (!fs::is_directory(folder.empty() ? fs::path(".") : folder, error)) {
    refuse(file, fmt::format("there is no folder '{}'", folder.string()));
  }
  if (fs::exists(place.path(), error) && ::access(place.path().c_str(), W_OK) != 0) refuse(file, errno);
  if (!place.is_replaced()) return;
  // A recording that another run is writing must not be replaced under it.
  if (const std::string holder = who_writes(place.path()); !holder.empty())
    refuse(file, "it is being written by " + holder);
}

/// Writes all bytes. Returns 0, or errno of what failed.
int write_all(int descriptor, std::string_view bytes) {
  MUROSIMF_ASSERT(descriptor >= 0);
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return count < 0 ? errno : EIO;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return 0;
}

/// Opens the file and writes all bytes. Returns 0, or errno of what failed.
int write_bytes(const fs::path& file, int flags, std::string_view bytes) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CLOEXEC | flags, 0666);
  if (descriptor < 0) return errno;
  const int failure = write_all(descriptor, bytes);
  const int closed = ::close(descriptor) == 0 ? 0 : errno;  // network file systems report lack of space only here
  return failure != 0 ? failure : closed;
}

/// Writes the file's data to the disk. Returns 0, or errno of what failed.
int sync_file(const fs::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return errno;
  const int failure = ::fsync(descriptor) == 0 || errno == EINVAL ? 0 : errno;
  ::close(descriptor);
  return failure;
}

constexpr int only_new = O_CREAT | O_EXCL;

void write_as(const fs::path& file, const std::string& bytes, PartFile::Replaces replaces) {
  const OutputPlace place(file);
  check_place(file, place);
  int failure = 0;
  if (place.descriptor() >= 0) {
    (void)std::fflush(nullptr);  // output of earlier calls precedes it
    failure = write_all(place.descriptor(), bytes);
  } else if (!place.is_replaced()) {
    failure = write_bytes(place.path(), 0, bytes);
  } else {
    PartFile part(file);
    failure = write_bytes(part.path(), only_new, bytes);
    if (failure == 0) part.commit(replaces);
  }
  if (failure != 0) refuse(file, failure);
}

}  // namespace

void check_writable(const fs::path& file) {
  const OutputPlace place(file);
  check_place(file, place);
  if (!place.is_replaced()) return;
  // Creating a file is the only reliable test: permissions, quotas and read-only file systems all count.
  const PartFile probe(file);
  if (const int failure = write_bytes(probe.path(), only_new, {}); failure != 0) refuse(file, failure);
}

void write_file(const fs::path& file, const std::string& bytes) { write_as(file, bytes, PartFile::Replaces::no_input); }

void replace_file(const fs::path& file, const std::string& bytes) {
  write_as(file, bytes, PartFile::Replaces::input_too);
}

PartFile::PartFile(const fs::path& file, Extension extension) : file_(file) {
  const OutputPlace place(file);
  check_place(file, place);
  if (!place.is_replaced()) refuse(file, "this is no ordinary file but a device or a pipe; name a file");
  place_ = place.path();
  part_ = part_of(place_, extension);
  half_.emplace(part_);
  ::unlink(part_.c_str());  // left by a process of the same number
}

PartFile::~PartFile() {
  if (!part_.empty()) ::unlink(part_.c_str());
}

void PartFile::commit(Replaces replaces) {
  MUROSIMF_ASSERT(!part_.empty());
  if (replaces == Replaces::no_input) check_not_input(place_);
  check_place(file_, OutputPlace(place_));
  struct stat before {};
  if (::stat(place_.c_str(), &before) == 0) {
    // A loss of power must not leave less than there was: the data first, then the name.
    if (const int failure = sync_file(part_); failure != 0) refuse(file_, failure);
    (void)::chmod(part_.c_str(), before.st_mode & 07777);
  }
  if (::rename(part_.c_str(), place_.c_str()) != 0) refuse(file_, errno);
  part_.clear();
  half_.reset();
}

}  // namespace murosimf::files
