/// call_watch.h - looks after calls that must come back: a thread of its own sends a signal to threads whose call is overdue.
#pragma once

#include <sys/types.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

namespace murosimf::connect {

/// [ns] Of a clock that only goes forward; may be called in signal handlers.
[[nodiscard]] std::int64_t wall_nanoseconds() noexcept;

/// What an overdue thread gets, every 50 ms until it has come back. Its handler is whoever makes the calls.
[[nodiscard]] int break_off_signal() noexcept;

class CallWatch {
 public:
  /// Where a thread says that it is in a call.
  struct Place {
    std::atomic<std::int64_t> due{0};  ///< [ns] of wall_nanoseconds(); 0: in no call
    std::atomic<pid_t> thread{0};
    bool taken = false;  ///< of CallWatch
  };

  /// Its thread begins with the first use and goes on to the end of the process.
  static CallWatch& the_one();

  /// For the calling thread, until it gives it back.
  [[nodiscard]] Place& take();
  void give_back(Place& place);
  /// From now on all threads in calls get the signal, due or not: a call may wait for what never comes. May be called in signal handlers.
  void alarm() noexcept { alarmed_ = true; }

 private:
  CallWatch();
  [[noreturn]] void look();

  std::atomic<bool> alarmed_{false};
  std::mutex mutex_;
  std::vector<std::unique_ptr<Place>> places_;  // threads come and go; places are used again
};

}  // namespace murosimf::connect
