#include "murosimf/connect/guarded_call.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <csetjmp>
#include <csignal>
#include <cstdint>
#include <cstring>

#include <fmt/format.h>

#include "murosimf/connect/call_watch.h"
#include "murosimf/connect/signal_stack.h"

namespace murosimf::connect {
namespace {

constexpr std::array crash_signals{SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};
constexpr unsigned longest_end = 60;  // [s] for reports after a crash

const char* name_of(int signal) noexcept {
  switch (signal) {
    case SIGSEGV: return "SIGSEGV";
    case SIGBUS: return "SIGBUS";
    case SIGFPE: return "SIGFPE";
    case SIGILL: return "SIGILL";
    default: return "SIGABRT";
  }
}

/// A call that is going on; its thread's signal handler finds it by `active`.
struct Running {
  sigjmp_buf back{};
  const GuardedCall* call = nullptr;
  std::int64_t began = 0;  // [ns]
  Running* outer = nullptr;
};
thread_local Running* active = nullptr;

void write_text(const char* text) noexcept {
  const auto written = ::write(STDERR_FILENO, text, std::strlen(text));
  (void)written;
}

/// Handlers that were there before.
std::array<struct sigaction, crash_signals.size()> previous;

void on_crash(int signal) {
  if (Running* running = active) {
    write_text("murosimf: ");
    write_text(running->call->who.c_str());
    write_text(": ");
    write_text(running->call->what.c_str());
    write_text(" crashed (");
    write_text(name_of(signal));
    write_text("); the run ends here\n");
    alarm(longest_end);
    siglongjmp(running->back, signal);
  }
  const auto* place = std::ranges::find(crash_signals, signal);
  sigaction(signal, &previous[static_cast<std::size_t>(place - crash_signals.begin())], nullptr);
  (void)raise(signal);
}

void on_break_off(int signal) {
  Running* running = active;
  if (!running || wall_nanoseconds() - running->began < running->call->limit.count()) return;  // it came back meanwhile
  siglongjmp(running->back, signal);
}

void handle_signals() {
  struct sigaction action {};
  action.sa_flags = SA_NODEFER | SA_ONSTACK;  // the jump does not give a mask back
  sigemptyset(&action.sa_mask);
  action.sa_handler = on_crash;
  for (std::size_t i = 0; i < crash_signals.size(); ++i) sigaction(crash_signals[i], &action, &previous[i]);
  action.sa_handler = on_break_off;
  action.sa_flags |= SA_RESTART;
  sigaction(break_off_signal(), &action, nullptr);
}

/// What a thread needs for its calls.
struct ThreadGuard {
  ThreadGuard() : place(CallWatch::the_one().take()) {}
  ~ThreadGuard() { CallWatch::the_one().give_back(place); }
  ThreadGuard(const ThreadGuard&) = delete;
  ThreadGuard& operator=(const ThreadGuard&) = delete;

  SignalStack stack;
  CallWatch::Place& place;
};

CallOutcome without_exceptions(const GuardedCall& guard, const std::function<void()>& call) {
  try {
    call();
    return {};
  } catch (const std::exception& error) {
    return {CallOutcome::threw, fmt::format("{}: {} threw: {}", guard.who, guard.what, error.what())};
  } catch (...) {
    return {CallOutcome::threw, fmt::format("{}: {} threw something that is no std::exception", guard.who, guard.what)};
  }
}

CallOutcome outcome_of(const GuardedCall& guard, int signal) {
  if (signal == break_off_signal()) {
    return {CallOutcome::late,
            fmt::format("{}: {} did not come back within {:g} s", guard.who, guard.what, seconds(guard.limit))};
  }
  return {CallOutcome::crashed, fmt::format("{}: {} crashed ({})", guard.who, guard.what, name_of(signal))};
}

}  // namespace

CallOutcome GuardedCall::operator()(const std::function<void()>& call) const noexcept {
  static const bool handled = (handle_signals(), true);
  (void)handled;
  thread_local ThreadGuard thread;
  Running running;
  running.call = this;
  running.outer = active;
  running.began = wall_nanoseconds();
  if (const int signal = sigsetjmp(running.back, 0); signal != 0) {
    thread.place.due = 0;
    active = active->outer;
    return outcome_of(*this, signal);
  }
  active = &running;
  thread.place.due = running.began + limit.count();
  CallOutcome outcome = without_exceptions(*this, call);
  thread.place.due = 0;
  active = running.outer;
  return outcome;
}

}  // namespace murosimf::connect
