#include "murosimf/studies/compare_sensors.h"

#include <algorithm>
#include <cmath>

namespace murosimf::studies {
namespace {

void see(double mine, double reference, double least, const std::string& name, OfAnother& worst) {
  const double off = std::abs(mine - reference) / std::max(reference, least);
  if (off > worst.value) worst = {off, name};
}

}  // namespace

InertialMeasures measures_of(const InertialRecord& record, double until) {
  InertialMeasures m;
  double forces = 0, rates = 0, count = 0;
  for (const InertialSample& sample : record.samples) {
    if (sample.time > until) break;
    if (sample.time < record.samples.front().time + settling) continue;
    forces += sample.force * sample.force;
    rates += sample.rate * sample.rate;
    m.force_peak = std::max(m.force_peak, std::abs(sample.force));
    ++count;
  }
  m.force_rms = std::sqrt(forces / std::max(count, 1.0));
  m.rate_rms = std::sqrt(rates / std::max(count, 1.0));
  return m;
}

void compare_sensors(const std::vector<InertialRecord>& mine, const std::vector<InertialRecord>& reference,
                     double until, Deviations& deviations) {
  for (std::size_t i = 0; i < std::min(mine.size(), reference.size()); ++i) {
    const InertialMeasures a = measures_of(mine[i], until), b = measures_of(reference[i], until);
    const std::string& name = reference[i].name;
    if (reference[i].accelerometer) {
      see(a.force_rms, b.force_rms, least_force, name, deviations.accelerometer);
      see(a.force_peak, b.force_peak, least_force, name, deviations.accelerometer_peak);
    }
    if (reference[i].gyroscope) see(a.rate_rms, b.rate_rms, least_sensor_rate, name, deviations.gyroscope);
  }
}

}  // namespace murosimf::studies
