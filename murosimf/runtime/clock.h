/// clock.h - pacer: how simulated time follows the wall clock: in real time, slower, faster, or as fast as possible.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "murosimf/runtime/pacer.h"

namespace murosimf {

/// Where wall time comes from; tests bring their own.
class WallTime {
 public:
  virtual ~WallTime() = default;
  [[nodiscard]] virtual Duration now() = 0;
  virtual void sleep_until(Duration time) = 0;
};

/// How late a simulation was, in wall time.
struct Lateness {
  std::int64_t late_steps = 0;  ///< steps that ended more than the tolerance behind schedule
  std::int64_t steps = 0;       ///< all steps
  Duration worst{};             ///< largest overrun
};

/// Of the steps since it was last told.
struct Overrun {
  Duration simulated{};  ///< present simulated time
  Lateness lateness;
};

class Clock final : public Pacer {
 public:
  /// `speed`: simulated seconds per wall second (1: real time); nothing: as fast as possible. Throws SetupError if it
  /// is not positive and finite.
  explicit Clock(std::optional<double> speed = std::nullopt, std::unique_ptr<WallTime> wall = nullptr);

  /// The schedule begins now: simulated time `simulated` is due at once.
  void start(Duration simulated) override;

  /// Returns when `simulated` is due. Does not wait if the simulation is late; after more than 100 ms of delay the
  /// schedule is moved instead of being caught up with in a rush. Returns within 20 ms of wall time once `stop` says true.
  void wait_until(Duration simulated, const StopRequest& stop = {});

  void after_step(Duration simulated, const StopRequest& stop) override { wait_until(simulated, stop); }

  /// Has `tell` called by wait_until() when steps were late: after the first second of wall time that had any, then after at least
  /// 2, 4, ... 64 s, so that a long run is not drowned.
  void publish_overruns(std::function<void(const Overrun&)> tell) { publish_ = std::move(tell); }

  /// Goes on with a wait that its `stop` has ended before the time was due.
  void wait_on(Duration simulated, const StopRequest& stop) {
    if (speed_) sleep_until(due(simulated), stop);
  }

  /// Of all steps.
  [[nodiscard]] const Lateness& lateness() const { return lateness_; }

  static constexpr Duration tolerance = std::chrono::milliseconds(2);

 private:
  [[nodiscard]] Duration due(Duration simulated) const;
  void sleep_until(Duration due, const StopRequest& stop);
  void count(Duration behind);
  void tell_of(Duration simulated, Duration wall);

  std::optional<double> speed_;
  std::unique_ptr<WallTime> wall_;
  Duration wall_start_{};
  Duration simulated_start_{};
  Lateness lateness_, untold_;
  std::function<void(const Overrun&)> publish_;
  Duration told_at_{}, silence_ = std::chrono::seconds(1);  // wall time
};

}  // namespace murosimf
