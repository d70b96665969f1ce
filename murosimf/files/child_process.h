/// child_process.h - other programs, started without a shell: run to their end with texts as their standard streams, or supplied with
/// bytes while they run.
///
/// They are searched for in PATH. Each is in its own process group: a signal that a terminal sends to this program's
/// group, as Ctrl-C does, does not reach it; the caller decides about its end.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <sys/types.h>

#include "murosimf/files/cleanup_guard.h"
#include "murosimf/files/file_pointer.h"

namespace murosimf::files {

struct ProcessResult {
  int exit_code = 0;  ///< -1 if a signal ended it
  std::string output, errors;
};

/// Runs `arguments[0]` with `input` as standard input, and waits for its end. Nothing if there is no such program. Throws
/// SetupError if the system cannot start one. Streams are unnamed temporary files, so that neither side ever blocks
/// the other.
[[nodiscard]] std::optional<ProcessResult> run_process(const std::vector<std::string>& arguments,
                                                       const std::string& input);

/// A program that is supplied with bytes while it runs.
class ChildPipe {
 public:
  /// Starts `arguments[0]`. Throws SetupError with `advice` if there is no such program, and if the system cannot start
  /// one.
  ChildPipe(const std::vector<std::string>& arguments, const std::string& advice);
  /// Ends the program if finish() was not called.
  ~ChildPipe();
  ChildPipe(const ChildPipe&) = delete;
  ChildPipe& operator=(const ChildPipe&) = delete;

  /// Waits until the program has taken all bytes. Throws SetupError with the last line of its errors if it has ended.
  void write(std::span<const std::byte> bytes);
  /// Sends no more bytes and waits for the program's end. Throws SetupError if it failed. Returns the last line of its errors; empty if there
  /// is none.
  std::string finish();

 private:
  [[nodiscard]] int wait() noexcept;
  [[noreturn]] void refuse();

  std::string program_;
  FilePtr errors_;
  int socket_ = -1;
  pid_t child_ = -1;
  std::optional<CleanupGuard> running_;
};

}  // namespace murosimf::files
