#include "apps/output_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include <fmt/format.h>

#include "murosimf/model/error.h"

namespace murosimf::app {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& file, int error) {
  throw SetupError(fmt::format("cannot write '{}': {}", file.string(), std::strerror(error)));
}

fs::path temporary(const fs::path& file) { return file.string() + ".part"; }

}  // namespace

void check_writable(const fs::path& file) {
  if (fs::is_directory(file)) refuse(file, EISDIR);
  const fs::path probe = temporary(file);
  std::FILE* stream = std::fopen(probe.c_str(), "wb");
  if (!stream) refuse(file, errno);
  std::fclose(stream);
  fs::remove(probe);
}

void write_file(const fs::path& file, const std::string& text) {
  const fs::path part = temporary(file);
  std::FILE* stream = std::fopen(part.c_str(), "wb");
  if (!stream) refuse(file, errno);
  const bool written = std::fwrite(text.data(), 1, text.size(), stream) == text.size();
  const bool closed = std::fclose(stream) == 0;
  if (!written || !closed || std::rename(part.c_str(), file.c_str()) != 0) {
    const int error = errno;
    fs::remove(part);
    refuse(file, error);
  }
}

void write_standard_output(const std::string& text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (!written || std::fflush(stdout) != 0) {
    throw SetupError(fmt::format("cannot write to standard output: {}", std::strerror(errno)));
  }
}

}  // namespace murosimf::app
