/// guarded_call.h - calls untrusted code: exceptions, crashes, calls that do not return and calls that would end the
/// program end the call, not the program.
///
/// A crash is one of SIGSEGV, SIGBUS, SIGFPE, SIGILL and SIGABRT in the thread of the call or in one that the code has started, std::terminate,
/// exit and its like (watched_functions.h), or a row that was written beyond its end (guarded_row.h). One line about it goes to standard
/// error at once, since nothing is certain afterwards; then the call is left by a jump. Memory and locks that the code held remain held; it
/// must not be called again. A program that has not ended a minute after a crash is killed. An overdue call is aborted by a signal from
/// a separate thread. Changes of the process and the thread are undone (process_state.h).
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>

#include "murosimf/control_software/guard/call_end.h"
#include "murosimf/control_software/guard/call_outcome.h"
#include "murosimf/world/time.h"

namespace murosimf::control_software {

/// State of the threads that a library has started. They may outlive everything else of it.
struct ForeignThreads : std::enable_shared_from_this<ForeignThreads> {
  std::string name{};
  std::atomic_flag taken{};
  CallEnd why{};                   ///< if `ended`
  std::atomic<bool> ended{false};  ///< one of them has crashed, or ended the program
};

struct GuardedCall {
  std::string name;  ///< "library 'libwalk.so' of blue1"
  std::string what;  ///< "its step"
  Duration limit{};  ///< of wall time
  /// Memory that it may write; null: no guarded rows.
  const GuardedRows* rows = nullptr;
  /// Threads that it starts; null: they are not watched.
  std::shared_ptr<ForeignThreads> threads = nullptr;
  /// Saves all of the process's state that could change before the call; otherwise only when it calls a function that changes it, which
  /// misses some ways.
  bool keeps_process = false;

  /// Any thread; several calls at the same time.
  [[nodiscard]] CallOutcome operator()(const std::function<void()>& call) const noexcept;
};

/// Outcome of threads that have crashed or ended the program.
[[nodiscard]] CallOutcome outcome_of(const ForeignThreads& threads);

/// Whether any call or thread of this process has crashed.
[[nodiscard]] bool software_has_crashed() noexcept;

}  // namespace murosimf::control_software
