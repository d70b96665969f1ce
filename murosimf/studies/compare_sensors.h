/// compare_sensors.h - how far what inertial sensors show is from what the reference's show.
#pragma once

#include <vector>

#include "murosimf/studies/compare_metrics.h"
#include "murosimf/studies/inertial_recorder.h"

namespace murosimf::studies {

/// Differences of smaller sizes are given as shares of these: a robot that stands shows noise.
inline constexpr double least_force = 0.5;         ///< [m/s^2]
inline constexpr double least_sensor_rate = 0.05;  ///< [rad/s]

/// [s] What is shown before is left out: robots that are put down come to rest on their contacts.
inline constexpr double settling = 0.1;

/// Of one sensor.
struct InertialMeasures {
  double force_rms = 0;   ///< [m/s^2] root of the mean of (|a| - g)^2
  double force_peak = 0;  ///< [m/s^2] largest ||a| - g|
  double rate_rms = 0;    ///< [rad/s] root of the mean of |w|^2
};

[[nodiscard]] InertialMeasures measures_of(const InertialRecord& record, double until);

/// Fills in the deviations of sensors up to `until` [s]: of each quantity the sensor that is off by most. Both robots have the same.
void compare_sensors(const std::vector<InertialRecord>& mine, const std::vector<InertialRecord>& reference,
                     double until, Deviations& deviations);

}  // namespace murosimf::studies
