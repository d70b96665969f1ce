/// leftovers.h - what a program that a signal ends must take away: half-written files, and programs that it has started.
///
///     const Leftover part(file);      // for as long as it is there
///     ...
///     remove_leftovers();             // in a signal's handler, before the program dies
#pragma once

#include <atomic>
#include <filesystem>

#include <sys/types.h>

namespace murosimf::files {

/// Known to remove_leftovers() while it lives. There are places for 32 at a time; more are not noted.
class Leftover {
 public:
  /// A file that nobody wants before it is whole and has got another name.
  explicit Leftover(const std::filesystem::path& file) noexcept;
  /// A child process that nobody waits for when this one is gone.
  explicit Leftover(pid_t child) noexcept;
  ~Leftover();
  Leftover(const Leftover&) = delete;
  Leftover& operator=(const Leftover&) = delete;

 private:
  std::atomic<int>* state_ = nullptr;  // of its place; null: none was free
};

/// Ends the children and removes the files. Nothing but system calls that a signal's handler may make.
void remove_leftovers() noexcept;

}  // namespace murosimf::files
