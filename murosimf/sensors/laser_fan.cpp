#include "murosimf/sensors/laser_fan.h"

#include <algorithm>
#include <string>

namespace murosimf::sensors {

const OptionTable<LaserOptions>& laser_options() {
  static const OptionTable<LaserOptions> table{
      {"rays", &LaserOptions::rays, "1", "evenly over the field of view, both ends included", 1, most_rays},
      {"fov", &LaserOptions::fov, "rad", "field of view, from the first ray to the last", 0, widest_fov},
      {"first_angle", &LaserOptions::first_angle, "rad", "of the first ray, from x towards y; without it: -fov/2",
       -2 * pi, 2 * pi},
      range_min_row<LaserOptions>(),
      range_max_row<LaserOptions>(),
  };
  return table;
}

Output laser_ranges(const SensorSpec& spec) {
  const LaserSector sector = laser_sector(spec);
  const Range range = laser_range(spec);
  Output output{
      "ranges",
      "m",
      {},
      {{"first_angle", sector.first}, {"fov", sector.fov}, {"range_min", range.min}, {"range_max", range.max}}};
  const int rays = sector.rays;
  for (int i = 0; i < rays; ++i) output.labels.push_back(std::to_string(i));
  return output;
}

LaserSector laser_sector(const SensorSpec& spec) {
  const LaserOptions options = options_of(spec, laser_options());
  // the option allows a rounding above a full turn
  const double fov = std::min(options.fov, 2 * pi);
  return {options.rays, options.first_angle.value_or(-0.5 * fov), fov};
}

Range laser_range(const SensorSpec& spec) { return checked(options_of(spec, laser_options()).range); }

}  // namespace murosimf::sensors
