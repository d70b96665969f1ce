/// timed_calls.h - calls that a simulation makes between two steps, when simulated time has come to them.
///
/// Those asked for before the first start are the simulation's schedule: every reset makes them again, and how far it has come is part
/// of the state. Later ones are their caller's: a reset forgets them, and a state that is loaded does not concern them.
#pragma once

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include "murosimf/math/assert.h"
#include "murosimf/world/time.h"

namespace murosimf {

class StateArchive;

struct TimedCall {
  Duration time{};
  std::function<void()> call;
};

class TimedCalls {
 public:
  /// At equal times in the order of asking.
  void schedule(Duration time, std::function<void()> call) { insert(schedule_, {time, std::move(call)}); }
  void add_later(Duration time, std::function<void()> call) { insert(later_, {time, std::move(call)}); }

  /// Calls make(call) with each that is due, the earliest first. now() is asked before each: a call may go to another time, or add
  /// further ones.
  template <class Now, class Make>
  void make_due(const Now& now, const Make& make);

  /// Those to come that were asked for later.
  [[nodiscard]] const std::vector<TimedCall>& later() const noexcept { return later_; }
  /// Neither a schedule nor calls to come.
  [[nodiscard]] bool empty() const noexcept { return schedule_.empty() && later_.empty(); }
  void set_later(std::vector<TimedCall> calls) { later_ = std::move(calls); }

  void go_back_to_start() noexcept;
  /// How far the schedule has come. Throws SetupError for a state of a simulation with another number of scheduled calls.
  void state(StateArchive& archive);

 private:
  static void insert(std::vector<TimedCall>& calls, TimedCall call);

  std::vector<TimedCall> schedule_;  // the earliest first
  std::size_t scheduled_done_ = 0;   // of them
  std::vector<TimedCall> later_;     // the next one first
};

// ---- definitions ----

template <class Now, class Make>
void TimedCalls::make_due(const Now& now, const Make& make) {
  const auto due = [&](const std::vector<TimedCall>& calls, std::size_t next) {
    return next < calls.size() && calls[next].time <= now();
  };
  for (;;) {
    MUROSIMF_ASSERT(scheduled_done_ <= schedule_.size());
    const bool scheduled = due(schedule_, scheduled_done_), other = due(later_, 0);
    if (!scheduled && !other) return;
    if (scheduled && !(other && later_[0].time < schedule_[scheduled_done_].time)) {
      make(schedule_[scheduled_done_++].call);
    } else {
      const TimedCall first = std::move(later_.front());
      later_.erase(later_.begin());  // before it is made: the call may add others
      make(first.call);
    }
  }
}

}  // namespace murosimf
