/// file_access.h - how names become files while something is built: which files may be read, where those of an earlier run stand now, and a
/// list of those that are read.
///
///     const auto read = std::make_shared<files::FilesRead>();
///     scene::Scene scene("walk", {.files = {.noted = read}});     // explicitly, with the scene's other options
///
/// What builds something from files takes a FileAccess with its options and opens a scope with it; readers of single files, which stand
/// deep below that, ask the scope of their thread. So two scenes are built in two threads, or one within another, each by its own access.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "murosimf/files/allowed_files.h"
#include "murosimf/files/files_read.h"
#include "murosimf/files/moved_files.h"

namespace murosimf::files {

struct FileAccess {
  std::shared_ptr<const AllowedFiles> only_from{};  ///< null: any file may be named
  std::shared_ptr<const MovedFiles> moved{};        ///< files of an earlier run; null: files are where they are
  std::shared_ptr<FilesRead> noted{};               ///< gets all that is read; null: it is not noted
};

/// Readers in this thread follow `access` until its end. What `access` leaves out is as in the scope around it: nothing inside widens what
/// may be read by leaving it out.
class FileScope {
 public:
  explicit FileScope(FileAccess access);
  ~FileScope() { end(); }
  FileScope(const FileScope&) = delete;
  FileScope& operator=(const FileScope&) = delete;

  /// In any thread.
  void end() noexcept;

  struct Level;  ///< of the scopes in each other

 private:
  std::shared_ptr<Level> level_;
};

// ---- For readers, in the thread that has opened the scope ----

/// Whether it may be read.
[[nodiscard]] bool may_be_read(const std::filesystem::path& file);
/// Whether there is anything that must not be read: then no other program may be started that reads for this thread.
[[nodiscard]] bool reads_are_limited() noexcept;
/// Null: files are where they are.
[[nodiscard]] const MovedFiles* moved_files() noexcept;
/// Of a file that is opened.
void note_file_read(const std::filesystem::path& file);
/// Of one that was found by a name (look_up_key), or (an empty path) of none.
void note_name_found(const std::string& key, const std::filesystem::path& file);

}  // namespace murosimf::files
