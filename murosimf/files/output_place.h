/// output_place.h - what the name of a result leads to: a file that is replaced, or a device, pipe or descriptor that is written to.
#pragma once

#include <filesystem>

namespace murosimf::files {

class OutputPlace {
 public:
  explicit OutputPlace(const std::filesystem::path& file);

  /// A file, or none yet: it gets a new one's name when that is whole. Else it is written directly.
  [[nodiscard]] bool is_replaced() const { return replaced_; }
  /// Of this process, for names like /dev/stdout and /proc/self/fd/3; -1: none.
  [[nodiscard]] int descriptor() const { return descriptor_; }
  /// Behind symbolic links, also where nothing is yet; absolute if its folder is there.
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;
  bool replaced_ = false;
};

}  // namespace murosimf::files
