#include "murosimf/control_software/python/python_reading.h"

#include <algorithm>
#include <memory>

#include "murosimf/math/assert.h"

namespace murosimf::control_software {
namespace {

sensors::SensorSpec spec_of(const PythonReadingOptions& options) {
  sensors::SensorSpec spec{.name = options.name, .type = "python", .rate = options.rate, .delay = options.delay};
  for (const auto& [output, deviation] : options.noise) spec.signals[output].noise = deviation;
  return spec;
}

}  // namespace

Rate execution_rate(const PythonReadingOptions& options, double step_rate) {
  return sensors::task_rate(spec_of(options), sensors::Watch::samples, step_rate);
}

PythonReading::PythonReading(Setup& setup, const std::vector<sensors::Output>& outputs,
                             const PythonReadingOptions& options)
    : Sensor(setup, spec_of(options), {.seed = options.seed}, outputs),
      rate_(options.rate),
      execution_(setup.period()) {
  written_.info = reading().info;
  written_.values.assign(reading().values.size(), 0.0);
}

void PythonReading::measure(std::span<double> values) noexcept {
  MUROSIMF_ASSERT(values.size() == written_.values.size());
  std::ranges::copy(written_.values, values.begin());
}

void PythonReading::start() { std::ranges::fill(written_.values, 0.0); }

}  // namespace murosimf::control_software
