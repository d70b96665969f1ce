#include "murosimf/control_software/guard/crash_signals.h"

#include <ucontext.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstring>
#include <exception>

#include "murosimf/control_software/guard/call_watch.h"
#include "murosimf/control_software/guard/foreign_call.h"
#include "murosimf/world/foreign_code.h"

namespace murosimf::control_software {
namespace {

constexpr std::array crash_signals{SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};

/// Handlers that were installed before.
std::array<struct sigaction, crash_signals.size()> previous;
std::terminate_handler previous_terminate = nullptr;

/// Returns the row whose bounds the faulty access has crossed.
GuardedRows::Found row_of(int signal, const siginfo_t& info, const GuardedRows* rows) {
  if (!rows || (signal != SIGSEGV && signal != SIGBUS) || info.si_code <= 0) return {};
  return rows->at(info.si_addr);
}

/// Returns the address of the failed instruction.
const void* place_of(const void* context) noexcept {
#if defined(__x86_64__)
  return reinterpret_cast<const void*>(static_cast<const ucontext_t*>(context)->uc_mcontext.gregs[REG_RIP]);
#elif defined(__aarch64__)
  return reinterpret_cast<const void*>(static_cast<const ucontext_t*>(context)->uc_mcontext.pc);
#else
  (void)context;
  return nullptr;
#endif
}

void on_crash(int signal, siginfo_t* info, void* context) {
  if (is_own_process()) {
    CallEnd why{.kind = CallEnd::signal, .number = signal};
    if (ForeignCall* running = ForeignCall::of_thread()) {
      why.row = row_of(signal, *info, running->call.rows);
      running->end(why);
    }
    if (ForeignThreads* owner = owner_of_thread()) end_thread(*owner, why);
  }
  if (const ForeignCode* code = ForeignCode::at(place_of(context))) {
    announce(code->name, "it", {.kind = CallEnd::signal, .number = signal});
  } else {
    announce_suspects(signal);
  }
  const auto* place = std::ranges::find(crash_signals, signal);
  sigaction(signal, &previous[static_cast<std::size_t>(place - crash_signals.begin())], nullptr);
  // raised again, so that the previous handler, or the default one, sees it: cores and reports stay as usual
  (void)raise(signal);
}

/// A crashed thread never ends: a call that joins it would take up to the limit.
bool waits_for_crashed_thread(const GuardedCall& call) { return call.threads && call.threads->ended; }

void on_break_off(int) {
  ForeignCall* running = ForeignCall::of_thread();
  if (!running) return;  // it has returned meanwhile
  const bool late = wall_nanoseconds() - running->began >= running->call.limit.count();
  if (!late && !waits_for_crashed_thread(running->call)) return;
  running->end({.kind = CallEnd::late});
}

/// Copies the text of the uncaught exception.
void note_exception(CallEnd& why) noexcept {
  if (!std::current_exception()) return;
  try {
    throw;
  } catch (const std::exception& error) {
    std::strncpy(why.exception.data(), error.what(), why.exception.size() - 1);
  } catch (...) {
    std::strncpy(why.exception.data(), "something that is no std::exception", why.exception.size() - 1);
  }
  // control characters would break the line of the report
  std::ranges::replace_if(
      why.exception, [](char c) { return (c > 0 && c < ' ') || c == 0x7f; }, ' ');
}

[[noreturn]] void on_terminate() noexcept {
  ForeignCall* const running = is_own_process() ? ForeignCall::of_thread() : nullptr;
  ForeignThreads* const owner = is_own_process() ? owner_of_thread() : nullptr;
  if (running || owner) {
    CallEnd why{.kind = CallEnd::terminate};
    note_exception(why);
    if (running) running->end(why);
    end_thread(*owner, why);
  }
  if (previous_terminate) previous_terminate();
  std::abort();
}

}  // namespace

void handle_crash_signals() {
  struct sigaction action {};
  action.sa_flags =
      SA_NODEFER | SA_ONSTACK | SA_SIGINFO;  // siglongjmp without a saved mask does not unblock the signal
  sigemptyset(&action.sa_mask);
  action.sa_sigaction = on_crash;
  for (std::size_t i = 0; i < crash_signals.size(); ++i) sigaction(crash_signals[i], &action, &previous[i]);
  struct sigaction late {};
  late.sa_flags = SA_NODEFER | SA_ONSTACK | SA_RESTART;
  sigemptyset(&late.sa_mask);
  late.sa_handler = on_break_off;
  sigaction(break_off_signal(), &late, nullptr);
  previous_terminate = std::set_terminate(on_terminate);
}

}  // namespace murosimf::control_software
