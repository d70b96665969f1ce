/// sensor_log.h - algorithm: records every sample of sensors of one entity.
///
/// Attached last, at the rate of the simulation's steps; a sample is recorded in the step in which it arrives, with the
/// instant at which it was taken.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "murosimf/logging/log_csv.h"
#include "murosimf/sensors/reading.h"
#include "murosimf/world/algorithm.h"
#include "murosimf/world/setup.h"

namespace murosimf::logging {

/// Recorded numbers of one sensor.
struct LoggedSensor {
  std::string sensor;
  std::vector<std::size_t> numbers;  ///< indices of its values
  std::vector<std::string> names;    ///< of the same, with unit
};

class SensorLog final : public Algorithm {
 public:
  /// Throws SetupError if the entity has no such sensor.
  SensorLog(Setup& setup, const std::vector<LoggedSensor>& logged);

  [[nodiscard]] Phase phase() const noexcept override { return Phase::observe; }
  void initialize() override;
  void step(const Instant& instant) noexcept override;

  /// One per sensor; addresses are stable. They grow with the run.
  [[nodiscard]] const std::deque<LogSeries>& series() const { return series_; }

 private:
  struct Source {
    const sensors::Reading& reading;
    std::vector<std::size_t> numbers;
    std::uint64_t samples = 0;  // recorded
  };

  void forget_from(Duration time);

  bool begins_ = true;
  std::vector<Source> sources_;
  std::deque<LogSeries> series_;  // by source
};

}  // namespace murosimf::logging
