/// speedometer.h - measured speed of simulated time: a mean over about the last second of wall time.
#pragma once

#include <chrono>

#include "murosimf/world/time.h"

namespace murosimf::session {

class Speedometer {
 public:
  using WallClock = std::chrono::steady_clock;

  /// Restarts the measurement.
  void restart(Duration simulated, WallClock::time_point wall = WallClock::now());
  void advance(Duration simulated, WallClock::time_point wall = WallClock::now());
  /// Simulated seconds per wall second since one to two half seconds ago, or since the restart.
  [[nodiscard]] double factor() const { return factor_; }

 private:
  struct Mark {
    Duration simulated{};
    WallClock::time_point wall;
  };
  Mark old_, newer_;  // half a second apart
  double factor_ = 0;
};

}  // namespace murosimf::session
