/// guarded_call.h - calls code that one does not trust: exceptions, crashes, calls that do not come back and calls that would end the
/// program end the call, not the program.
///
/// A crash is one of SIGSEGV, SIGBUS, SIGFPE, SIGILL and SIGABRT in the thread of the call or in one that the code has begun, std::terminate,
/// exit and its like (watched_functions.h), or a row that was written beyond its end (guarded_row.h). One line about it goes to standard
/// error at once, since nothing is certain afterwards; then the call is left by a jump. What the code held (memory, locks) stays so; it
/// must not be called again. A program that has not ended a minute after a crash is ended. A call is broken off by a signal that a
/// thread of its own sends when the limit has passed. What it has changed of the process and the thread is put back (process_state.h).
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>

#include "murosimf/connect/guard/call_end.h"
#include "murosimf/connect/guard/call_outcome.h"
#include "murosimf/model/time.h"

namespace murosimf::connect {

/// What becomes of threads that a library has begun. They may outlive everything else of it.
struct ForeignThreads : std::enable_shared_from_this<ForeignThreads> {
  std::string who{};
  std::atomic_flag taken{};
  CallEnd why{};                   ///< if `ended`
  std::atomic<bool> ended{false};  ///< one of them has crashed, or ended the program
};

struct GuardedCall {
  std::string who;   ///< "library 'libwalk.so' of blue1"
  std::string what;  ///< "its step"
  Duration limit{};  ///< of wall time
  /// What it may write to; null: nothing that is guarded.
  const GuardedRows* rows = nullptr;
  /// Of threads that it begins; null: nobody looks after them.
  std::shared_ptr<ForeignThreads> threads = nullptr;
  /// All that could change of the process is kept before; else only if it calls what changes it, which misses some ways.
  bool keeps_process = false;

  /// Any thread; several at the same time.
  [[nodiscard]] CallOutcome operator()(const std::function<void()>& call) const noexcept;
};

/// Of threads that have not come back in order.
[[nodiscard]] CallOutcome outcome_of(const ForeignThreads& threads);

/// Whether any call or thread of this process has crashed.
[[nodiscard]] bool software_has_crashed() noexcept;

}  // namespace murosimf::connect
