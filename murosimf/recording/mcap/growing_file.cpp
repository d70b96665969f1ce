#include "murosimf/recording/mcap/growing_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include <fmt/format.h>

#include "murosimf/model/error.h"
#include "murosimf/recording/mcap/crc32.h"

namespace murosimf::recording {

GrowingFile::GrowingFile(const std::filesystem::path& file)
    : file_(file), descriptor_(::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)) {
  if (descriptor_ < 0) refuse(errno);
}

GrowingFile::~GrowingFile() { ::close(descriptor_); }

void GrowingFile::append(std::string_view bytes) {
  for (std::string_view left = bytes; !left.empty();) {
    const ssize_t count = ::write(descriptor_, left.data(), left.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) {
      const int error = count < 0 ? errno : EIO;
      // half a record would hide that the others are whole; devices have no length
      [[maybe_unused]] const int ignored = ::ftruncate(descriptor_, static_cast<off_t>(size_));
      refuse(error);
    }
    left.remove_prefix(static_cast<std::size_t>(count));
  }
  size_ += bytes.size();
  crc_ = crc32(bytes, crc_);
}

void GrowingFile::sync() {
  if (::fdatasync(descriptor_) != 0 && errno != EINVAL) refuse(errno);  // EINVAL: a device has nothing to wait for
}

void GrowingFile::refuse(int error) {
  throw SetupError(fmt::format("cannot write '{}': {}", file_.string(), std::generic_category().message(error)));
}

}  // namespace murosimf::recording
