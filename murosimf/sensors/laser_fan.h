/// laser_fan.h - what both kinds of laser range finders have: a fan of rays, and how its distances are shown.
#pragma once

#include "murosimf/collision/scan.h"
#include "murosimf/sensors/range.h"
#include "murosimf/sensors/reading.h"
#include "murosimf/sensors/sensor_options.h"

namespace murosimf::sensors {

struct LaserOptions {
  int rays = 1081;
  double fov = 1.5 * pi;                ///< [rad]
  std::optional<double> first_angle{};  ///< [rad] of the first ray; nothing: half of the fov to the right
  Range range{.min = 0.06, .max = 30};
};

[[nodiscard]] const OptionTable<LaserOptions>& laser_options();

/// Output `ranges`, with a label "0", "1", ... for each ray of the spec.
[[nodiscard]] Output laser_ranges(const SensorSpec& spec);

/// Where the rays are.
struct LaserSector {
  int rays = 0;
  double first = 0, fov = 0;  ///< [rad] from x towards y: of the first ray, and on to the last
  [[nodiscard]] collision::Fan fan() const { return {rays, first, fov}; }
};

/// Of the options rays, fov and first_angle. Throws SetupError that names the one that is impossible.
[[nodiscard]] LaserSector laser_sector(const SensorSpec& spec);

/// Of the options range_min and range_max. The same.
[[nodiscard]] Range laser_range(const SensorSpec& spec);

}  // namespace murosimf::sensors
