#include "murosimf/control_software/guard/foreign_call.h"

#include <pthread.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstring>
#include <string_view>
#include <utility>

#include "murosimf/control_software/guard/call_watch.h"

namespace murosimf::control_software {
namespace {

constexpr unsigned longest_end = 60;  // [s] for reports after a crash

thread_local ForeignCall* active = nullptr;
thread_local ForeignThreads* owner = nullptr;
std::atomic<bool> crashed{false};
std::mutex changing_the_process;
std::atomic<pid_t> own_process{0};
std::atomic<bool> software_child{false};

void write_text(const char* text) noexcept {
  const auto written = ::write(STDERR_FILENO, text, std::strlen(text));
  (void)written;
}

std::array<char, 500> suspects{};  // "library 'a.so', library 'b.so'"; those that there is room for

/// In a forked child process: it is in no call. In a child of the software, exit must end that process only.
void in_child() noexcept {
  own_process = ::getpid();
  software_child = software_child || active || owner;
  active = nullptr;
  owner = nullptr;
}

}  // namespace

void know_children() {
  own_process = ::getpid();
  (void)::pthread_atfork(nullptr, nullptr, in_child);
}

ForeignCall::ForeignCall(const GuardedCall& guarded) : call(guarded), began(wall_nanoseconds()) {}

ForeignCall* ForeignCall::of_thread() noexcept { return active; }

void ForeignCall::enter() noexcept { outer_ = std::exchange(active, this); }

/// A child process that returns from the call in which it was forked would be a second, unrequested simulation.
void ForeignCall::leave() noexcept {
  if (active != this) ::_exit(0);
  active = outer_;
}

void ForeignCall::end(const CallEnd& end) noexcept {
  // left before announcing: a crash while reporting must reach the handler of the program, not this call again
  leave();
  why = end;
  if (end.kind != CallEnd::late) announce(call.name, call.what, end);
  siglongjmp(back, 1);
}

void ForeignCall::keep_process() noexcept {
  if (process_) return;
  ForeignCall* const self = std::exchange(active, nullptr);  // the functions called here are watched, too
  alone_ = std::unique_lock(changing_the_process);
  process_.emplace();
  active = self;
}

ProcessChanges ForeignCall::put_back() noexcept {
  // inactive meanwhile, since restoring calls the watched functions
  ForeignCall* const around = std::exchange(active, nullptr);
  ProcessChanges changes = thread_.put_back();
  if (process_) changes.add(process_->put_back());
  process_.reset();
  if (alone_) alone_.unlock();
  active = around;
  return changes;
}

void announce(const std::string& name, const std::string& what, const CallEnd& why) noexcept {
  crashed = true;
  write_text("murosimf: ");
  write_text(name.c_str());
  write_text(": ");
  write_text(what.c_str());
  write_text(" ");
  why.say(write_text);
  write_text("; the run ends here\n");
  alarm(longest_end);  // the process may be too damaged to end by itself
}

/// In memory that is there before any crash: the handler of a signal must not allocate.
void note_suspect(const std::string& name) {
  static std::mutex noting;
  const std::lock_guard lock(noting);
  const std::string_view known(suspects.data());
  if (known.find(name) != std::string_view::npos || known.size() + name.size() + 3 > suspects.size()) return;
  const std::string more = (known.empty() ? "" : ", ") + name;
  std::ranges::copy(more, suspects.begin() + static_cast<std::ptrdiff_t>(known.size()));
}

/// Only functions that are safe in handlers of signals.
void announce_suspects(int signal) noexcept {
  if (suspects.front() == 0) return;
  write_text("murosimf: the program crashed (");
  write_text(crash_name(signal));
  write_text(") outside of all calls of others' code; this may have damaged its memory before: ");
  write_text(suspects.data());
  write_text("\n");
}

bool software_has_crashed() noexcept { return crashed; }

bool is_child_of_software() noexcept { return software_child; }

/// By the process id: children by vfork share the memory, so a flag there would not distinguish them.
bool is_own_process() noexcept { return ::getpid() == own_process; }

ForeignThreads* owner_of_thread() noexcept { return owner; }

void set_owner_of_thread(ForeignThreads* of_thread) noexcept { owner = of_thread; }

void end_thread(ForeignThreads& threads, const CallEnd& why) noexcept {
  if (!threads.taken.test_and_set()) {
    threads.why = why;
    announce(threads.name, "a thread of its own", why);
    threads.ended = true;
    CallWatch::the_one().alarm();
  }
  while (true) ::pause();  // it holds locks and a stack that others may use: it must not unwind
}

}  // namespace murosimf::control_software
