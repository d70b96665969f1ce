/// cleanup_guard.h - cleanup for a program that a signal ends: removes half-written files, and ends programs that it has started.
///
///     const CleanupGuard part(file);      // while the file exists
///     ...
///     run_cleanup();             // in a signal's handler, before the program dies
#pragma once

#include <atomic>
#include <filesystem>

#include <sys/types.h>

namespace murosimf::files {

/// Registered with run_cleanup() while it lives. There are places for 32 at a time; more are not registered.
class CleanupGuard {
 public:
  /// A file that is incomplete until it is renamed.
  explicit CleanupGuard(const std::filesystem::path& file) noexcept;
  /// A child process that must not outlive this one.
  explicit CleanupGuard(pid_t child) noexcept;
  ~CleanupGuard();
  CleanupGuard(const CleanupGuard&) = delete;
  CleanupGuard& operator=(const CleanupGuard&) = delete;

 private:
  std::atomic<int>* state_ = nullptr;  // state of its place; null: none was free
};

/// Ends the children and removes the files. Uses only system calls that are allowed in a signal's handler.
void run_cleanup() noexcept;

}  // namespace murosimf::files
