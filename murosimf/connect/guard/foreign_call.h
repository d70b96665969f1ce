/// foreign_call.h - which call of code that one does not trust a thread is in, for what may end it from within: signal handlers
/// (crash_signals.h) and functions of the C library (watched_functions.h).
#pragma once

#include <atomic>
#include <csetjmp>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>

#include "murosimf/connect/guard/call_end.h"
#include "murosimf/connect/guard/guarded_call.h"
#include "murosimf/connect/guard/process_state.h"

namespace murosimf::connect {

/// A call that is going on.
class ForeignCall {
 public:
  explicit ForeignCall(const GuardedCall& call);

  /// That of this thread; null: none.
  [[nodiscard]] static ForeignCall* of_thread() noexcept;
  void enter() noexcept;  ///< is that of this thread from now on
  void leave() noexcept;  ///< the one around it is again

  /// Ends it, as seen from within: says so and jumps back to where `back` was set.
  [[noreturn]] void end(const CallEnd& why) noexcept;
  /// It is about to change something of the process: keeps that before. Only one call of all threads at a time goes on from here.
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

/// Says at once, on standard error, that the call has ended so, and that the run ends with it.
void announce(const std::string& who, const std::string& what, const CallEnd& why) noexcept;

/// From now on children of the process are told from it. Once.
void know_children();

/// Code of others that is in the process from now on, for the words of a crash that happens elsewhere.
void note_suspect(const std::string& name);
/// Says that the program has crashed outside of all guarded calls, if there are suspects: they may have damaged its memory before.
void announce_suspects(int signal) noexcept;

/// Whether this process was forked by control software: what the simulator does at the end of the program is not its business.
[[nodiscard]] bool is_child_of_software() noexcept;

/// Whether this process is the one whose threads make the calls, and not a child of one.
[[nodiscard]] bool is_own_process() noexcept;

/// Of a thread that control software has begun: null in all others.
[[nodiscard]] ForeignThreads* owner_of_thread() noexcept;
void set_owner_of_thread(ForeignThreads* owner) noexcept;
/// It has ended the program from there: says so, and never comes back.
[[noreturn]] void end_thread(ForeignThreads& owner, const CallEnd& why) noexcept;

}  // namespace murosimf::connect
