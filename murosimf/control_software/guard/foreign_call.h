/// foreign_call.h - the call of untrusted code that a thread executes, for code that may end it from within: signal handlers
/// (crash_signals.h) and functions of the C library (watched_functions.h).
#pragma once

#include <atomic>
#include <csetjmp>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>

#include "murosimf/control_software/guard/call_end.h"
#include "murosimf/control_software/guard/guarded_call.h"
#include "murosimf/control_software/guard/process_state.h"

namespace murosimf::control_software {

/// A call in progress.
class ForeignCall {
 public:
  explicit ForeignCall(const GuardedCall& call);

  /// The call of this thread; null: none.
  [[nodiscard]] static ForeignCall* of_thread() noexcept;
  void enter() noexcept;  ///< becomes the call of this thread
  void leave() noexcept;  ///< the enclosing call becomes current again

  /// Ends the call from within: reports it and jumps to where `back` was set.
  [[noreturn]] void end(const CallEnd& why) noexcept;
  /// Called before the code changes something of the process: saves that state. Only one call of all threads continues from here at a time.
  void keep_process() noexcept;
  [[nodiscard]] ProcessChanges put_back() noexcept;

  const GuardedCall& call;
  const std::int64_t began;  ///< [ns]
  sigjmp_buf back{};
  CallEnd why{};

 private:
  ForeignCall* outer_ = nullptr;
  CallState thread_;
  std::unique_lock<std::mutex> alone_;
  std::optional<ProcessState> process_;
};

/// Reports at once, on standard error, that the call has ended like this, and that the run ends with it.
void announce(const std::string& name, const std::string& what, const CallEnd& why) noexcept;

/// Distinguishes children of the process from it, from now on. Once.
void know_children();

/// Registers code of others that is loaded from now on, for the message about a crash elsewhere.
void note_suspect(const std::string& name);
/// Reports that the program has crashed outside of all guarded calls, if there are suspects: they may have damaged its memory before.
void announce_suspects(int signal) noexcept;

/// Whether this process was forked by control software: the simulator's work at the end of the program must not run in it.
[[nodiscard]] bool is_child_of_software() noexcept;

/// Whether this process is the one that makes the calls, and not a child of it.
[[nodiscard]] bool is_own_process() noexcept;

/// Owner of a thread that control software has started: null in all others.
[[nodiscard]] ForeignThreads* owner_of_thread() noexcept;
void set_owner_of_thread(ForeignThreads* owner) noexcept;
/// Called when such a thread has ended the program: reports it, and never returns.
[[noreturn]] void end_thread(ForeignThreads& owner, const CallEnd& why) noexcept;

}  // namespace murosimf::control_software
