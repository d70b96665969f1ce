/// scratch_folder.h - a new folder for files that nobody needs later.
///
/// It is locked as long as its process lives. What a process has left that was killed is removed by the next one that needs such a folder.
#pragma once

#include <filesystem>

namespace murosimf::recording {

class ScratchFolder {
 public:
  /// Where temporary files are on this machine. Throws SetupError.
  ScratchFolder();
  /// Removes it with all that is in it.
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  int lock_ = -1;  // of the folder; ends with the process, however that ends
};

}  // namespace murosimf::recording
