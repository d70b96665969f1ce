/// sweep_file.h - the runs of a sweep that are done, one a line, so that the sweep can continue after any interruption.
///
///     MuRoSimF sweep 1
///     {"scene": ...}             what the sweep is: one line
///     17 0.25 nan 3              a run, and its results with all digits
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "murosimf/files/file_pointer.h"
#include "murosimf/model/error.h"

namespace murosimf::studies {

/// Results by index of the run.
using FinishedRuns = std::map<std::size_t, std::vector<double>>;

/// Another sweep writes the file.
class SweepFileBusy : public SetupError {
 public:
  using SetupError::SetupError;
};

class SweepFile {
 public:
  /// Continues the file if it is there. `what`: one line. Throws SetupError: it is of another sweep, or cannot be written;
  /// SweepFileBusy.
  SweepFile(std::filesystem::path file, const std::string& what, std::size_t results);

  /// By index, those that were in it.
  [[nodiscard]] const FinishedRuns& known() const { return known_; }
  /// Is in the file when it returns. One thread at a time. Throws SetupError.
  void add(std::size_t run, const std::vector<double>& values);

 private:
  void open();

  std::filesystem::path file_;
  FinishedRuns known_;
  files::FilePtr stream_;
};

/// What is in all such files of a folder, "*.txt", also in those that others write at this moment; nothing, if there is no folder.
/// Throws SetupError: a file is of another sweep, or two files have different results of one run.
[[nodiscard]] FinishedRuns finished_runs(const std::filesystem::path& folder, const std::string& what,
                                         std::size_t results);

}  // namespace murosimf::studies
