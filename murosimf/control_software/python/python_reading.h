/// python_reading.h - what a class in Python gives as a sensor: its samples have rate, delay and noise as those of any other sensor.
///
/// The class writes true values; samples of them are taken right after its call, in the execution of it.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "murosimf/sensors/sensor.h"

namespace murosimf::control_software {

struct PythonReadingOptions {
  std::string name;                     ///< of the sensor, unique on its robot
  double rate = 0;                      ///< [Hz] of calls, each of which gives a sample
  double delay = 0;                     ///< [s] from the sample until control software can read it
  std::map<std::string, double> noise;  ///< deviation of each sample by output, in its unit; "": of all others
  std::uint64_t seed = 0;               ///< of the noise
};

/// At which the sensor is attached in a simulation with `step_rate` [Hz] steps per second.
[[nodiscard]] Rate execution_rate(const PythonReadingOptions& options, double step_rate);

class PythonReading final : public sensors::Sensor {
 public:
  /// Throws SetupError: the entity has a sensor of this name, there is no such output, the rate is more than that of execution.
  PythonReading(Setup& setup, const std::vector<sensors::Output>& outputs, const PythonReadingOptions& options);

  /// Where the class writes: values of all outputs, one after the other, which stay until it writes others.
  [[nodiscard]] sensors::Reading& written() { return written_; }
  /// Whether the class is called in the execution at `now`.
  [[nodiscard]] bool is_due(Duration now) const { return rate_.falls_on(now, execution_); }

 private:
  void measure(std::span<double> values) noexcept override;
  void start() override;
  void memory(StateArchive& archive) override { archive.elements(std::span(written_.values)); }

  sensors::Reading written_;
  Rate rate_;
  Duration execution_;
};

}  // namespace murosimf::control_software
