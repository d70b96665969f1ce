/// progress.h - how far a long command is, and how long it will still take: one line on the terminal that changes.
///
///     [############............................] 9.0 of 30.0 s, 12 s left
#pragma once

#include <chrono>
#include <string>

namespace murosimf::app {

/// Shows nothing if standard error is no terminal.
class Progress {
 public:
  Progress();
  /// Takes the line away.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `share` of the work is done, 0 to 1. At most ten lines a second are drawn, so it may be called as often as one likes.
  void show(double share, const std::string& words);
  /// Takes the line away until it is next shown.
  void hide();

 private:
  using WallClock = std::chrono::steady_clock;

  bool shown_;
  WallClock::time_point start_ = WallClock::now(), next_ = start_;
};

/// "12 s left", "3 min 20 s left", "2 h 05 min left" after `elapsed` [s] for this share; empty while nothing can be said.
[[nodiscard]] std::string time_left(double share, double elapsed);

}  // namespace murosimf::app
