/// sensor_history.h - the last samples of a sensor, in the order in which they came.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <utility>
#include <vector>

#include "murosimf/sensors.h"

namespace murosimf::python {

class SensorHistory {
 public:
  /// `most`: samples that are kept.
  SensorHistory(Sensor sensor, std::size_t most) : sensor_(std::move(sensor)), most_(most) {
    seen_ = sensor_.samples();
  }

  /// After a step: adds the sample that has arrived, if one has. A reset, or a state from before, begins anew.
  void look() {
    const std::uint64_t samples = sensor_.samples();
    if (samples == seen_) return;
    if (samples < seen_) rows_.clear();
    seen_ = samples;
    if (samples == 0) return;
    rows_.push_back({sensor_.time()});
    rows_.back().insert(rows_.back().end(), sensor_.values().begin(), sensor_.values().end());
    if (rows_.size() > most_) rows_.pop_front();
  }

  [[nodiscard]] std::size_t size() const { return rows_.size(); }
  /// Time [s] and values of each sample, one after the other.
  [[nodiscard]] std::vector<double> numbers() const {
    std::vector<double> all;
    for (const std::vector<double>& row : rows_) all.insert(all.end(), row.begin(), row.end());
    return all;
  }

 private:
  Sensor sensor_;
  std::size_t most_;
  std::uint64_t seen_ = 0;
  std::deque<std::vector<double>> rows_;
};

}  // namespace murosimf::python
