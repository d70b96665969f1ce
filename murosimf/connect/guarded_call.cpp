#include "murosimf/connect/guarded_call.h"

#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <condition_variable>
#include <csetjmp>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <ctime>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include <fmt/format.h>

namespace murosimf::connect {
namespace {

constexpr std::array crash_signals{SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};
constexpr unsigned longest_end = 60;  // [s] for reports after a crash
constexpr auto watch_period = std::chrono::milliseconds(50);

int break_off_signal() { return SIGRTMIN + 7; }

const char* name_of(int signal) noexcept {
  switch (signal) {
    case SIGSEGV: return "SIGSEGV";
    case SIGBUS: return "SIGBUS";
    case SIGFPE: return "SIGFPE";
    case SIGILL: return "SIGILL";
    default: return "SIGABRT";
  }
}

std::int64_t nanoseconds_now() noexcept {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return 1'000'000'000 * static_cast<std::int64_t>(time.tv_sec) + time.tv_nsec;
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
  if (!running || nanoseconds_now() - running->began < running->call->limit.count()) return;  // it came back meanwhile
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

/// A stack for the handler of this thread: that of the call may be the one that has overflowed.
class SignalStack {
 public:
  SignalStack() {
    stack_t present{};
    if (sigaltstack(nullptr, &present) == 0 && (present.ss_flags & SS_DISABLE) == 0) return;  // somebody's
    memory_ = std::make_unique<char[]>(size);
    stack_t stack{};
    stack.ss_sp = memory_.get();
    stack.ss_size = size;
    sigaltstack(&stack, nullptr);
  }
  ~SignalStack() {
    if (!memory_) return;
    stack_t none{};
    none.ss_flags = SS_DISABLE;
    sigaltstack(&none, nullptr);
  }
  SignalStack(const SignalStack&) = delete;
  SignalStack& operator=(const SignalStack&) = delete;

 private:
  static constexpr std::size_t size = 64 * 1024;  // [byte]
  std::unique_ptr<char[]> memory_;
};

/// Where threads say that they are in a call. Threads come and go; their places are used again.
class Watch {
 public:
  struct Place {
    std::atomic<std::int64_t> due{0};  // [ns] 0: in no call
    std::atomic<pid_t> thread{0};
    bool taken = false;  // guarded by the mutex
  };

  static Watch& the_one() {
    static auto* watch = new Watch;  // its thread goes on to the end of the process
    return *watch;
  }
  Place& take() {
    const std::lock_guard lock(mutex_);
    const auto free = std::ranges::find_if(places_, [](const auto& place) { return !place->taken; });
    Place& place = free == places_.end() ? *places_.emplace_back(std::make_unique<Place>()) : **free;
    place.taken = true;
    place.thread = static_cast<pid_t>(::syscall(SYS_gettid));
    return place;
  }
  void give_back(Place& place) {
    const std::lock_guard lock(mutex_);
    place.taken = false;
  }

 private:
  Watch() {
    std::thread([this] { look(); }).detach();
  }

  [[noreturn]] void look() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, nullptr);  // signals are for the program's threads
    while (true) {
      std::this_thread::sleep_for(watch_period);
      const std::lock_guard lock(mutex_);
      for (const auto& place : places_) {
        const std::int64_t due = place->due;
        if (due != 0 && nanoseconds_now() > due)
          ::syscall(SYS_tgkill, getpid(), place->thread.load(), break_off_signal());
      }
    }
  }

  std::mutex mutex_;
  std::vector<std::unique_ptr<Place>> places_;
};

/// What a thread needs for its calls.
struct ThreadGuard {
  ThreadGuard() : place(Watch::the_one().take()) {}
  ~ThreadGuard() { Watch::the_one().give_back(place); }
  ThreadGuard(const ThreadGuard&) = delete;
  ThreadGuard& operator=(const ThreadGuard&) = delete;

  SignalStack stack;
  Watch::Place& place;
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
  running.began = nanoseconds_now();
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
