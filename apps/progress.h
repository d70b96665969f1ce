/// progress.h - progress of a long command and its remaining time: one line on the terminal that changes, or a line a minute in a
/// log.
///
///     [############............................] 9.0 of 30.0 s, 12.3 times real time, 12 s left
#pragma once

#include <chrono>
#include <string>

namespace murosimf::app {

/// On standard error. If that is no terminal, nothing in the first minute, then a plain line a minute.
class Progress {
 public:
  Progress();
  /// Removes the line.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `share` of the work is done, 0 to 1. At most ten lines a second are drawn, however often it is called.
  void show(double share, const std::string& words);
  /// Removes the line until it is next shown.
  void hide();

 private:
  using WallClock = std::chrono::steady_clock;

  bool terminal_;
  WallClock::time_point start_ = WallClock::now(), next_;
};

/// "12.3 times real time" for so many simulated seconds in `elapsed` [s]; empty while nothing can be said.
[[nodiscard]] std::string rate_of(double simulated, double elapsed);

/// "12 s left", "3 min 20 s left", "2 h 05 min left" after `elapsed` [s] for this share; empty while nothing can be said.
[[nodiscard]] std::string time_left(double share, double elapsed);

}  // namespace murosimf::app
