#include "murosimf/sensors/laser.h"

namespace murosimf::sensors {
namespace {

int rays_of(const SensorSpec& spec) { return checked_count(spec, "rays", 1081, {1, 100000}); }

Output ranges(int rays) {
  Output output{"ranges", "m", {}};
  for (int i = 0; i < rays; ++i) output.labels.push_back(std::to_string(i));
  return output;
}

collision::Fan fan_of(const SensorSpec& spec) {
  const double opening = checked_opening(spec, "opening", 1.5 * pi);
  const double first = checked_number(spec, "first_angle", -0.5 * opening, {-2 * pi, 2 * pi});
  return {rays_of(spec), first, opening};
}

}  // namespace

Laser::Laser(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings)
    : Sensor(setup, spec, surroundings, {ranges(rays_of(spec))}),
      robot_(setup.entity()),
      mounting_(setup, spec),
      range_(checked_range(spec, {0.06, 30})),
      fan_(fan_of(spec)),
      scene_(all_around(setup, surroundings)) {}

void Laser::measure(std::span<double> values) noexcept {
  scene_.refresh();
  const geometry::Pose here{mounting_.position(), mounting_.orientation()};
  scene_.cast(fan_, here, {.range = range_.farthest, .without = &robot_}, values);
  present(values);
}

void Laser::present(std::span<double> values) noexcept {
  for (double& distance : values) distance = range_.shown(distance);
}

}  // namespace murosimf::sensors
