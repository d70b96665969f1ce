#include "murosimf/sensors/laser_fan.h"

#include <string>

namespace murosimf::sensors {
namespace {

int rays_of(const SensorSpec& spec) { return checked_count(spec, "rays", 1081, {1, 100000}); }

}  // namespace

Output laser_ranges(const SensorSpec& spec) {
  Output output{"ranges", "m", {}};
  for (int i = 0; i < rays_of(spec); ++i) output.labels.push_back(std::to_string(i));
  return output;
}

LaserSector laser_sector(const SensorSpec& spec) {
  const double fov = checked_fov(spec, "fov", 1.5 * pi);
  const double first = checked_number(spec, "first_angle", -0.5 * fov, {-2 * pi, 2 * pi});
  return {rays_of(spec), first, fov};
}

Range laser_range(const SensorSpec& spec) { return checked_range(spec, {0.06, 30}); }

}  // namespace murosimf::sensors
