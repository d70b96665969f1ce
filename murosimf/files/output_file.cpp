#include "murosimf/files/output_file.h"

#include <cerrno>
#include <cstdio>
#include <optional>
#include <system_error>

#include <fmt/format.h>
#include <unistd.h>

#include "murosimf/files/file_pointer.h"
#include "murosimf/files/leftovers.h"
#include "murosimf/model/error.h"

namespace murosimf::files {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& file, const std::string& reason) {
  throw SetupError(fmt::format("cannot write '{}': {}", file.string(), reason));
}

/// A device or pipe cannot be replaced.
bool is_special(const fs::path& file) {
  std::error_code error;
  return fs::is_other(file, error);
}

fs::path part_of(const fs::path& file) { return file.string() + fmt::format(".{}.part", ::getpid()); }

void check_place(const fs::path& file) {
  std::error_code error;
  if (fs::is_directory(file, error)) refuse(file, "it is a folder");
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, error)) refuse(file, fmt::format("there is no folder '{}'", folder.string()));
}

/// 0, or errno of what failed.
int write_bytes(const fs::path& file, const std::string& bytes) {
  FilePtr out(std::fopen(file.c_str(), "wb"));
  if (!out) return errno;
  if (std::fwrite(bytes.data(), 1, bytes.size(), out.get()) != bytes.size()) return errno;
  return std::fclose(out.release()) == 0 ? 0 : errno;
}

}  // namespace

void check_writable(const fs::path& file) {
  check_place(file);
  if (is_special(file)) return;
  const fs::path probe = part_of(file);
  const Leftover half_file(probe);
  const int failure = write_bytes(probe, {});
  std::error_code error;
  fs::remove(probe, error);
  if (failure != 0) refuse(file, std::generic_category().message(failure));
}

void write_file(const fs::path& file, const std::string& bytes) {
  check_place(file);
  const bool special = is_special(file);
  const fs::path target = special ? file : part_of(file);
  std::error_code error;
  std::optional<Leftover> half_file;
  if (!special) half_file.emplace(target);
  int failure = write_bytes(target, bytes);
  if (failure == 0 && !special) {
    fs::rename(target, file, error);
    failure = error.value();
  }
  if (failure == 0) return;
  if (!special) fs::remove(target, error);
  refuse(file, std::generic_category().message(failure));
}

}  // namespace murosimf::files
