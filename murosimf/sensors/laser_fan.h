/// laser_fan.h - what both kinds of laser range finders have: a fan of rays, and how its distances are shown.
#pragma once

#include "murosimf/collision/scan.h"
#include "murosimf/sensors/numbers.h"
#include "murosimf/sensors/reading.h"

namespace murosimf::sensors {

/// Output `ranges`, with a label "0", "1", ... for each ray of the spec.
[[nodiscard]] Output laser_ranges(const SensorSpec& spec);

/// Of the numbers rays, opening and first_angle (laser.h). Throws SetupError that names the one that is impossible.
[[nodiscard]] collision::Fan laser_fan(const SensorSpec& spec);

/// Of the numbers nearest and farthest.
[[nodiscard]] Range laser_range(const SensorSpec& spec);

}  // namespace murosimf::sensors
