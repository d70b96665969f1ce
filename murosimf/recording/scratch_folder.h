/// scratch_folder.h - a new folder for temporary files.
///
/// It is locked during the lifetime of its process. Folders of processes that were killed are removed by the next one that needs such a folder.
#pragma once

#include <filesystem>

namespace murosimf::recording {

class ScratchFolder {
 public:
  /// In the machine's folder for temporary files. Throws SetupError.
  ScratchFolder();
  /// Removes it with its contents.
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  int lock_ = -1;  // of the folder; released by the system when the process ends
};

}  // namespace murosimf::recording
