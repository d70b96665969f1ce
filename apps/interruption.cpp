#include "apps/interruption.h"

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <ctime>
#include <string_view>

#include "murosimf/files/cleanup_guard.h"

namespace murosimf::app {
namespace {

constexpr std::int64_t one_gesture = 100'000'000;  // [ns]

// what the handler touches
std::atomic<bool> gentle{false};
std::atomic<int> first_signal{0};
std::atomic<std::int64_t> first_time{0};  // [ns]
static_assert(std::atomic<std::int64_t>::is_always_lock_free);

std::int64_t nanoseconds_now() noexcept {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return 1'000'000'000 * static_cast<std::int64_t>(time.tv_sec) + time.tv_nsec;
}

void say_on_terminal(std::string_view text) noexcept {
  if (isatty(STDERR_FILENO) == 0) return;
  const auto written = ::write(STDERR_FILENO, text.data(), text.size());
  (void)written;
}

/// Whether the command may end by itself.
bool ask(int signal) noexcept {
  if (!gentle) return false;
  int none = 0;
  if (!first_signal.compare_exchange_strong(none, signal)) return nanoseconds_now() - first_time < one_gesture;
  first_time = nanoseconds_now();
  say_on_terminal("\r\033[Kstopping; once more stops at once\n");
  return true;
}

void on_signal(int signal) {
  const int saved = errno;
  if (!ask(signal)) {
    files::run_cleanup();
    (void)std::signal(signal, SIG_DFL);
    (void)raise(signal);  // comes when the handler has returned
  }
  errno = saved;
}

void handle(int signal) {
  struct sigaction action {};
  action.sa_handler = on_signal;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  for (const int other : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&action.sa_mask, other);
  sigaction(signal, &action, nullptr);
}

bool is_ignored(int signal) {
  struct sigaction action {};
  return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

}  // namespace

void catch_signals() {
  handle(SIGINT);
  handle(SIGTERM);
  if (!is_ignored(SIGHUP)) handle(SIGHUP);
  (void)std::signal(SIGXFSZ, SIG_IGN);  // a limit of file sizes (ulimit -f) is an error of writing, as a full disk is
}

void end_gently() { gentle = true; }

bool interrupted() { return first_signal != 0; }

std::string signal_name() {
  switch (first_signal) {
    case SIGINT: return "SIGINT";
    case SIGTERM: return "SIGTERM";
    case SIGHUP: return "SIGHUP";
    default: return {};
  }
}

int exit_code() { return interrupted() ? 128 + first_signal : 0; }

}  // namespace murosimf::app
