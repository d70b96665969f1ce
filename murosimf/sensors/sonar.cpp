#include "murosimf/sensors/sonar.h"

#include <algorithm>
#include <cmath>

#include "murosimf/math/assert.h"

namespace murosimf::sensors {
namespace {

std::vector<Vec3d> cone(const SensorSpec& spec) {
  const SonarOptions options = options_of(spec, sonar_options());
  const int rays = options.rays;
  const double fov = std::min(options.fov, 2 * pi);
  // equal parts of the cone's solid angle, turned by the golden angle: evenly spread for any number of rays
  MUROSIMF_ASSERT(rays >= 1);
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

const OptionTable<SonarOptions>& sonar_options() {
  static const OptionTable<SonarOptions> table{
      {"rays", &SonarOptions::rays, "1", "in the cone; the first is its axis", 1, most_rays},
      {"fov", &SonarOptions::fov, "rad", "width of the cone, from side to side", 0, widest_fov},
      range_min_row<SonarOptions>(),
      range_max_row<SonarOptions>(),
  };
  return table;
}

const OptionTable<RangeFinderOptions>& rangefinder_options() {
  static const OptionTable<RangeFinderOptions> table{
      range_min_row<RangeFinderOptions>(),
      range_max_row<RangeFinderOptions>(),
  };
  return table;
}

NearestOfRays::NearestOfRays(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings,
                             std::vector<Vec3d> directions, const Range& range)
    : Sensor(setup, spec, surroundings, {{"range", "m", {}}}),
      robot_(setup.entity()),
      mounting_(setup, spec),
      range_(checked(range)),
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
    : NearestOfRays(setup, spec, surroundings, cone(spec), options_of(spec, sonar_options()).range) {}

RangeFinder::RangeFinder(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings)
    : NearestOfRays(setup, spec, surroundings, {{0, 0, 1}}, options_of(spec, rangefinder_options()).range) {}

}  // namespace murosimf::sensors
