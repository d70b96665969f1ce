#include "murosimf/files/output_place.h"

#include <algorithm>
#include <charconv>
#include <string>
#include <system_error>

#include <fmt/format.h>
#include <unistd.h>

namespace murosimf::files {
namespace {

namespace fs = std::filesystem;

constexpr int most_links = 40;  // as the kernel follows

/// 3 for /proc/self/fd/3, by any path; else -1. Such a link shows the name of a file, but refers to an open one.
int descriptor_at(const fs::path& file) {
  std::error_code error;
  const std::string name = file.filename().string();
  int number = -1;
  const auto [end, failure] = std::from_chars(name.data(), name.data() + name.size(), number);
  if (failure != std::errc{} || end != name.data() + name.size() || number < 0) return -1;
  const fs::path folder = fs::canonical(file.parent_path(), error);
  const bool is_ours = !error && (folder == fmt::format("/proc/{}/fd", ::getpid()) ||
                                  folder == fmt::format("/proc/{0}/task/{0}/fd", ::getpid()));
  return is_ours ? number : -1;
}

}  // namespace

OutputPlace::OutputPlace(const fs::path& file) : path_(file) {
  std::error_code error;
  for (int i = 0; i < most_links; ++i) {
    descriptor_ = descriptor_at(path_);
    if (descriptor_ >= 0) return;
    const fs::path target = fs::read_symlink(path_, error);
    if (error) break;
    path_ = target.is_absolute() ? target : path_.parent_path() / target;
  }
  const fs::path folder = fs::canonical(path_.has_parent_path() ? path_.parent_path() : fs::path("."), error);
  if (!error) path_ = folder / path_.filename();
  replaced_ = !fs::is_other(path_, error);
}

}  // namespace murosimf::files
