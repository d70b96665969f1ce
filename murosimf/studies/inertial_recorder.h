/// inertial_recorder.h - algorithm: records what the inertial sensors of a robot show, in sizes that do not depend on how it is turned.
///
/// It takes every sample of the sensors, with their filters and noise, when it has arrived, and changes nothing.
#pragma once

#include <string>
#include <vector>

#include "murosimf/sensors/reading.h"
#include "murosimf/world/algorithm.h"
#include "murosimf/world/setup.h"

namespace murosimf::studies {

struct InertialSample {
  double time = 0;   ///< [s] at which it was taken
  double force = 0;  ///< [m/s^2] |a| - g: 0 at rest
  double rate = 0;   ///< [rad/s] |w|
};

/// One sensor with an accelerometer, a gyroscope or both.
struct InertialRecord {
  std::string name;
  bool accelerometer = false, gyroscope = false;
  std::vector<InertialSample> samples;
};

class InertialRecorder final : public Algorithm {
 public:
  /// `longest` [s]: for which memory is set aside.
  InertialRecorder(Setup& setup, double longest);

  [[nodiscard]] Phase phase() const noexcept override { return Phase::observe; }
  void initialize() override {}
  void step(const Instant& instant) noexcept override;

  [[nodiscard]] const std::vector<InertialRecord>& records() const { return records_; }

 private:
  struct Source {
    const sensors::Reading* reading;
    std::span<const double> force, rate;  // empty: it has none
    std::uint64_t seen = 0;               // samples
  };
  std::vector<Source> sources_;
  std::vector<InertialRecord> records_;  // as sources_
  double gravity_;                       // [m/s^2]
};

}  // namespace murosimf::studies
