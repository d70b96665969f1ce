/// timer.h - when something is due that happens at a rate of simulated time, also after a jump in time.
#pragma once

#include "murosimf/world/time.h"

namespace murosimf::ros2 {

class Timer {
 public:
  explicit Timer(double rate) : period_(from_seconds(1 / rate)) {}

  /// At most once for an instant; at multiples of the period.
  [[nodiscard]] bool is_due(Duration now) {
    if (now < next_ && next_ - now <= period_) return false;
    next_ = (now / period_ + 1) * period_;
    return true;
  }

 private:
  Duration period_, next_{};
};

}  // namespace murosimf::ros2
