/// cleanup_guard.h - what a program that a signal ends must take away: half-written files, and programs that it has started.
///
///     const CleanupGuard part(file);      // for as long as it is there
///     ...
///     run_cleanup();             // in a signal's handler, before the program dies
#pragma once

#include <atomic>
#include <filesystem>

#include <sys/types.h>

namespace murosimf::files {

/// Known to run_cleanup() while it lives. There are places for 32 at a time; more are not noted.
class CleanupGuard {
 public:
  /// A file that nobody wants before it is whole and has got another name.
  explicit CleanupGuard(const std::filesystem::path& file) noexcept;
  /// A child process that nobody waits for when this one is gone.
  explicit CleanupGuard(pid_t child) noexcept;
  ~CleanupGuard();
  CleanupGuard(const CleanupGuard&) = delete;
  CleanupGuard& operator=(const CleanupGuard&) = delete;

 private:
  std::atomic<int>* state_ = nullptr;  // of its place; null: none was free
};

/// Ends the children and removes the files. Nothing but system calls that a signal's handler may make.
void run_cleanup() noexcept;

}  // namespace murosimf::files
