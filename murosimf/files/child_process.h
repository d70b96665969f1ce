/// child_process.h - runs another program without a shell, with texts as its standard streams.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace murosimf::files {

struct ProcessResult {
  int exit_code = 0;  ///< -1 if a signal ended it
  std::string output, errors;
};

/// Runs `arguments[0]`, looked up in PATH, with `input` as standard input, and waits for its end. Nothing if there is no such
/// program. Throws SetupError if the system cannot start one. Streams are unnamed temporary files, so that neither side
/// ever waits for the other.
[[nodiscard]] std::optional<ProcessResult> run_process(const std::vector<std::string>& arguments,
                                                       const std::string& input);

}  // namespace murosimf::files
