#include "murosimf/sensors/sonar.h"

#include <cmath>

namespace murosimf::sensors {
namespace {

std::vector<Vec3d> cone(const SensorSpec& spec) {
  const int rays = checked_count(spec, "rays", 61, {1, 100000});
  const double fov = checked_fov(spec, "fov", 15 * pi / 180);
  const double part = rays > 1 ? (1 - std::cos(fov / 2)) / (rays - 1) : 0;
  std::vector<Vec3d> directions;
  for (int k = 0; k < rays; ++k) {
    const double along = 1 - part * k, across = std::sqrt(std::max(1 - along * along, 0.0));
    const double about = k * pi * (3 - std::sqrt(5.0));
    directions.push_back({along, across * std::cos(about), across * std::sin(about)});
  }
  return directions;
}

}  // namespace

NearestOfRays::NearestOfRays(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings,
                             std::vector<Vec3d> directions, const Range& usual)
    : Sensor(setup, spec, surroundings, {{"range", "m", {}}}),
      robot_(setup.entity()),
      mounting_(setup, spec),
      range_(checked_range(spec, usual)),
      directions_(std::move(directions)),
      view_(setup, surroundings) {}

void NearestOfRays::measure(std::span<double> values) noexcept {
  collision::QueryScene& scene = view_.now();
  const Mat3d axes = mounting_.orientation();
  const Vec3d here = mounting_.position();
  bool found = false;
  double nearest = range_.max;
  for (const Vec3d& direction : directions_) {
    const auto hit = scene.cast({here, axes * direction}, {.range = nearest, .without = &robot_});
    if (!hit) continue;
    found = true;
    nearest = hit->distance;
  }
  values[0] = range_.shown(found ? nearest : std::numeric_limits<double>::infinity());
}

void NearestOfRays::present(std::span<double> values) noexcept { values[0] = range_.shown(values[0]); }

Sonar::Sonar(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings)
    : NearestOfRays(setup, spec, surroundings, cone(spec), {0.02, 4}) {}

RangeFinder::RangeFinder(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings)
    : NearestOfRays(setup, spec, surroundings, {{0, 0, 1}}, {}) {}

}  // namespace murosimf::sensors
