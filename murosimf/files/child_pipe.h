/// child_pipe.h - another program that is fed bytes while it runs.
#pragma once

#include <cstddef>
#include <cstdio>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <sys/types.h>

#include "murosimf/files/leftovers.h"

namespace murosimf::files {

class ChildPipe {
 public:
  /// Starts `arguments[0]`, looked up in PATH, without a shell. Throws SetupError with `advice` if there is no such
  /// program, and if the system cannot start one. It is in a process group of its own: Ctrl-C on a terminal, and whatever
  /// else is sent to this program's group, does not reach it.
  ChildPipe(const std::vector<std::string>& arguments, const std::string& advice);
  /// Ends the program if finish() was not called.
  ~ChildPipe();
  ChildPipe(const ChildPipe&) = delete;
  ChildPipe& operator=(const ChildPipe&) = delete;

  /// Waits until the program has taken all bytes. Throws SetupError with the last line of its errors if it has ended.
  void write(std::span<const std::byte> bytes);
  /// No more bytes: waits for the program's end. Throws SetupError if it was not content.
  void finish();

 private:
  [[nodiscard]] int wait() noexcept;
  [[noreturn]] void refuse();

  std::string program_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> errors_;
  int socket_ = -1;
  pid_t child_ = -1;
  std::optional<Leftover> running_;
};

}  // namespace murosimf::files
