/// laser_fan.h - what both kinds of laser range finders have: a fan of rays, and how its distances are shown.
#pragma once

#include "murosimf/collision/scan.h"
#include "murosimf/sensors/numbers.h"
#include "murosimf/sensors/reading.h"

namespace murosimf::sensors {

/// Output `ranges`, with a label "0", "1", ... for each ray of the spec.
[[nodiscard]] Output laser_ranges(const SensorSpec& spec);

/// Where the rays are.
struct LaserSector {
  int rays = 0;
  double first = 0, fov = 0;  ///< [rad] from x towards y: of the first ray, and on to the last
  [[nodiscard]] collision::Fan fan() const { return {rays, first, fov}; }
};

/// Of the numbers rays, fov and first_angle (laser.h). Throws SetupError that names the one that is impossible.
[[nodiscard]] LaserSector laser_sector(const SensorSpec& spec);

/// Of the numbers range_min and range_max.
[[nodiscard]] Range laser_range(const SensorSpec& spec);

}  // namespace murosimf::sensors
