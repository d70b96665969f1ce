#include "murosimf/logging/sensor_log.h"

#include <algorithm>

namespace murosimf::logging {

SensorLog::SensorLog(Setup& setup, const std::vector<LoggedSensor>& logged) {
  for (const LoggedSensor& one : logged) {
    sources_.push_back({sensors::read_reading(setup, one.sensor), one.numbers});
    series_.push_back({.names = one.names, .times = {}, .values = {}});
  }
}

void SensorLog::initialize() {
  for (Source& source : sources_) source.samples = 0;
  begins_ = true;
}

/// What stands there of a run before this one, or before its robot came back.
void SensorLog::forget_from(Duration time) {
  for (LogSeries& series : series_) {
    const auto later = std::lower_bound(series.times.begin(), series.times.end(), time);
    series.times.erase(later, series.times.end());
    series.values.resize(series.times.size() * series.names.size());
  }
}

/// A sensor samples less often than the world steps: its count of samples tells whether there is a new one.
void SensorLog::step(const Instant& instant) noexcept {
  if (begins_) forget_from(instant.now);
  begins_ = false;
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    Source& source = sources_[i];
    if (source.reading.samples == source.samples) continue;
    source.samples = source.reading.samples;
    series_[i].times.push_back(source.reading.time);
    for (const std::size_t number : source.numbers) series_[i].values.push_back(source.reading.values[number]);
  }
}

}  // namespace murosimf::logging
