/// call_watch.h - watches calls that must return: a separate thread sends a signal to threads whose call is overdue.
#pragma once

#include <sys/types.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

namespace murosimf::control_software {

/// [ns] Monotonic time; may be called in signal handlers.
[[nodiscard]] std::int64_t wall_nanoseconds() noexcept;

/// Signal for an overdue thread, sent every 50 ms until its call has returned. The caller of the code installs the handler.
[[nodiscard]] int break_off_signal() noexcept;

class CallWatch {
 public:
  /// Slot in which a thread registers its present call.
  struct Place {
    std::atomic<std::int64_t> due{0};  ///< [ns] of wall_nanoseconds(); 0: in no call
    std::atomic<pid_t> thread{0};
    bool taken = false;  ///< of CallWatch
  };

  /// The thread starts at the first use and runs until the process ends.
  static CallWatch& the_one();

  /// Reserves a slot for the calling thread, until it is given back.
  [[nodiscard]] Place& take();
  void give_back(Place& place);
  /// From now on all threads in calls receive the signal, overdue or not: a call may wait for a crashed thread. May be called in signal handlers.
  void alarm() noexcept { alarmed_ = true; }

 private:
  CallWatch();
  [[noreturn]] void look();

  std::atomic<bool> alarmed_{false};
  std::mutex mutex_;
  std::vector<std::unique_ptr<Place>> places_;  // slots are reused by later threads
};

}  // namespace murosimf::control_software
