#include "murosimf/studies/compare_sensors.h"

#include <algorithm>
#include <cmath>

#include "murosimf/math/assert.h"

namespace murosimf::studies {
namespace {

void keep_largest(double mine, double reference, double least, const std::string& name, OfAnother& worst) {
  MUROSIMF_ASSERT(least > 0);
  const double off = std::abs(mine - reference) / std::max(reference, least);
  if (off > worst.value) worst = {off, name};
}

}  // namespace

InertialMeasures measures_of(const InertialRecord& record, double until) {
  InertialMeasures m;
  double forces = 0, rates = 0, count = 0;
  for (const InertialSample& sample : record.samples) {
    if (sample.time > until) break;
    // The robot may have been put down at the start and still come to rest.
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
      keep_largest(a.force_rms, b.force_rms, least_force, name, deviations.accelerometer);
      keep_largest(a.force_peak, b.force_peak, least_force, name, deviations.accelerometer_peak);
    }
    if (reference[i].gyroscope) keep_largest(a.rate_rms, b.rate_rms, least_sensor_rate, name, deviations.gyroscope);
  }
}

}  // namespace murosimf::studies
