#include "murosimf/files/input_file.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <system_error>

#include <fmt/format.h>

#include "murosimf/files/file_access.h"
#include "murosimf/files/file_pointer.h"
#include "murosimf/files/file_roles.h"
#include "murosimf/files/xml_element.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::files {
namespace {

[[noreturn]] void refuse_input(const std::filesystem::path& file, const std::string& reason) {
  throw SetupError(one_line(fmt::format("{}: {}", file.string(), reason)));
}

[[noreturn]] void refuse_large(const std::filesystem::path& file, std::uintmax_t most) {
  refuse_input(file, fmt::format("the file is too large: at most {} MB of such a file are read", most / 1'000'000));
}

/// The bytes of an open file, at most `most` and one more block.
std::string bytes_of(std::FILE* stream, std::uintmax_t most) {
  MUROSIMF_ASSERT(stream != nullptr);
  std::string bytes;
  std::string block(1 << 16, '\0');
  // Counted while reading: the size that the system reports may be wrong or change.
  while (bytes.size() <= most) {
    const std::size_t count = std::fread(block.data(), 1, block.size(), stream);
    if (count == 0) break;
    bytes.append(block, 0, count);
  }
  return bytes;
}

}  // namespace

std::uintmax_t check_input_file(const std::filesystem::path& file, std::uintmax_t most) {
  if (!may_be_read(file)) refuse_input(file, "this file is in none of the folders that may be read here");
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::not_found) refuse_input(file, "there is no such file");
  if (error) refuse_input(file, fmt::format("the file cannot be read: {}", error.message()));
  if (std::filesystem::is_directory(status)) refuse_input(file, "this is a folder, not a file");
  if (!std::filesystem::is_regular_file(status)) {
    refuse_input(file, "this is no ordinary file but a device or a pipe; copy what it holds into a file");
  }
  if (::access(file.c_str(), R_OK) != 0) {
    refuse_input(file, fmt::format("the file cannot be read: {}", std::generic_category().message(errno)));
  }
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error) refuse_input(file, fmt::format("the file cannot be read: {}", error.message()));
  if (size > most) refuse_large(file, most);
  // Recorded last: a refused file is neither an input of the command nor part of a recording.
  note_input(file);
  note_file_read(file);
  return size;
}

std::string read_input_file(const std::filesystem::path& file, std::uintmax_t most) {
  check_input_file(file, most);
  const FilePtr stream(std::fopen(file.c_str(), "rb"));
  if (!stream) refuse_input(file, fmt::format("the file cannot be read: {}", std::generic_category().message(errno)));
  std::string bytes = bytes_of(stream.get(), most);
  if (std::ferror(stream.get()) != 0) refuse_input(file, "the file cannot be read to its end");
  if (bytes.size() > most) refuse_large(file, most);  // it has grown, or reports no size (/proc)
  return bytes;
}

}  // namespace murosimf::files
