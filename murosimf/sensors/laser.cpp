#include "murosimf/sensors/laser.h"

namespace murosimf::sensors {

Laser::Laser(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings)
    : Sensor(setup, spec, surroundings, {laser_ranges(spec)}),
      robot_(setup.entity()),
      mounting_(setup, spec),
      range_(laser_range(spec)),
      fan_(laser_sector(spec).fan()),
      view_(setup, surroundings) {}

void Laser::measure(std::span<double> values) noexcept {
  const Transformd here{mounting_.position(), mounting_.orientation()};
  view_.now().cast(fan_, here, {.range = range_.max, .without = &robot_}, values);
  // ranges beyond the limits as the device shows them
  present(values);
}

void Laser::present(std::span<double> values) noexcept {
  for (double& distance : values) distance = range_.shown(distance);
}

}  // namespace murosimf::sensors
