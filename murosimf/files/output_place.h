/// output_place.h - the target of a result's name: a file that is replaced, or a device, pipe or descriptor that is written to.
#pragma once

#include <filesystem>

namespace murosimf::files {

class OutputPlace {
 public:
  explicit OutputPlace(const std::filesystem::path& file);

  /// Whether it is a file, or does not exist yet: a new file gets its name when complete. Else it is written directly.
  [[nodiscard]] bool is_replaced() const { return replaced_; }
  /// Descriptor of this process, for names like /dev/stdout and /proc/self/fd/3; -1: none.
  [[nodiscard]] int descriptor() const { return descriptor_; }
  /// The path behind symbolic links, also if it does not exist yet; absolute if its folder exists.
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;
  bool replaced_ = false;
};

}  // namespace murosimf::files
