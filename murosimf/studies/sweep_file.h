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

namespace murosimf::studies {

class SweepFile {
 public:
  /// Continues the file if it is there. `what`: one line. Throws SetupError: it is of another sweep, or cannot be written,
  /// as while another sweep writes it.
  SweepFile(std::filesystem::path file, const std::string& what, std::size_t results);

  /// By index, those that were in it.
  [[nodiscard]] const std::map<std::size_t, std::vector<double>>& known() const { return known_; }
  /// Is in the file when it returns. One thread at a time. Throws SetupError.
  void add(std::size_t run, const std::vector<double>& values);

 private:
  void open();
  void read(const std::string& text, const std::string& head, std::size_t results);

  std::filesystem::path file_;
  std::map<std::size_t, std::vector<double>> known_;
  std::uintmax_t good_bytes_ = 0;  // whole lines
  files::FilePtr stream_;
};

}  // namespace murosimf::studies
