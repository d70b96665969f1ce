#include "murosimf/control_software/guard/call_watch.h"

#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <ctime>
#include <thread>

#include "murosimf/math/assert.h"

namespace murosimf::control_software {
namespace {

constexpr auto watch_period = std::chrono::milliseconds(50);

}  // namespace

std::int64_t wall_nanoseconds() noexcept {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return 1'000'000'000 * static_cast<std::int64_t>(time.tv_sec) + time.tv_nsec;
}

int break_off_signal() noexcept { return SIGRTMIN + 7; }

CallWatch& CallWatch::the_one() {
  // never destroyed: detached threads may use it while static objects are destroyed
  static auto* watch = new CallWatch;
  return *watch;
}

CallWatch::CallWatch() {
  std::thread([this] { look(); }).detach();
}

/// Places are used again and never freed: the watching thread may be reading one.
CallWatch::Place& CallWatch::take() {
  const std::lock_guard lock(mutex_);
  const auto free = std::ranges::find_if(places_, [](const auto& place) { return !place->taken; });
  Place& place = free == places_.end() ? *places_.emplace_back(std::make_unique<Place>()) : **free;
  place.taken = true;
  place.thread = static_cast<pid_t>(::syscall(SYS_gettid));
  return place;
}

void CallWatch::give_back(Place& place) {
  const std::lock_guard lock(mutex_);
  MUROSIMF_ASSERT(place.taken);
  place.taken = false;
}

void CallWatch::look() {
  sigset_t all;
  sigfillset(&all);
  pthread_sigmask(SIG_BLOCK, &all, nullptr);  // signals must reach the program's own threads
  while (true) {
    std::this_thread::sleep_for(watch_period);
    const std::lock_guard lock(mutex_);
    for (const auto& place : places_) {
      const std::int64_t due = place->due;
      // Repeated each period until the call has ended: a handler may have run before the jump target was set.
      if (due == 0 || (wall_nanoseconds() <= due && !alarmed_)) continue;
      ::syscall(SYS_tgkill, getpid(), place->thread.load(), break_off_signal());
    }
  }
}

}  // namespace murosimf::control_software
