/// unpacked_files.h - the files of a recorded run, unpacked into a folder for the lifetime of this object.
#pragma once

#include <filesystem>

#include "murosimf/recording/mcap/mcap_reader.h"
#include "murosimf/recording/scratch_folder.h"

namespace murosimf::recording {

class UnpackedFiles {
 public:
  /// The file at /PATH is at folder()/PATH: from the recording, or, where that has only a hash, a link to the file on this machine
  /// (places_of() in recorded_paths.h).
  /// Throws SetupError with the file that is missing or has changed.
  explicit UnpackedFiles(const McapReader& file);

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_.path(); }

 private:
  void unpack(const McapReader& file);
  void write(const std::filesystem::path& path, const std::string& bytes) const;
  void link(const std::filesystem::path& path, const std::string& size_and_hash, const McapReader& file) const;
  [[nodiscard]] std::filesystem::path place_of(const std::filesystem::path& path) const;

  ScratchFolder folder_;
};

}  // namespace murosimf::recording
