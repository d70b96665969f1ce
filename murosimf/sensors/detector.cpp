#include "murosimf/sensors/detector.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"
#include "murosimf/sensors/ground_truth.h"

namespace murosimf::sensors {
namespace {

std::vector<Entity*> looked_at(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings) {
  std::vector<Entity*> entities = sensed_entities(spec, surroundings);
  const auto self = std::find(entities.begin(), entities.end(), &setup.entity());
  if (self != entities.end()) {
    if (!spec.objects.empty()) {
      throw SetupError(fmt::format("'{}' carries the detector: it is not seen", setup.entity().name()));
    }
    entities.erase(self);
  }
  return entities;
}

std::vector<Output> detections(const std::vector<Entity*>& entities) {
  std::vector<Output> outputs;
  for (const Entity* entity : entities) {
    outputs.push_back({entity->name(), "m, rad, rad", {"distance", "azimuth", "elevation"}});
  }
  return outputs;
}

/// Beginning of the names of its random numbers.
std::string stream_name(const Setup& setup, const SensorSpec& spec) {
  return fmt::format("{}/{}/", setup.entity().name(), spec.name);
}

Seen seen(Setup other, const collision::QueryScene& scene) {
  return {&other.entity(), other.read(properties::position), other.read(properties::orientation),
          scene.shapes(other.entity())};
}

}  // namespace

Detector::Numbers::Numbers(const SensorSpec& spec)
    : half_azimuth(0.5 * checked_fov(spec, "fov_azimuth", 2 * pi / 3)),
      half_elevation(0.5 * checked_fov(spec, "fov_elevation", 2 * pi / 3, pi)),
      range(checked_range(spec, {.min = 0.1})),
      visible_share(checked_number(spec, "visible_share", 0.25, {0, 1})),
      misses(checked_number(spec, "misses", 0, {0, 1})),
      distance_noise(checked_number(spec, "distance_noise", 0)),
      azimuth_noise(checked_number(spec, "azimuth_noise", 0)),
      elevation_noise(checked_number(spec, "elevation_noise", 0)) {}

Detector::Detector(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings)
    : Sensor(setup, spec, surroundings, detections(looked_at(setup, spec, surroundings))),
      robot_(setup.entity()),
      mounting_(setup, spec),
      numbers_(spec),
      offsets_(surroundings.seed, stream_name(setup, spec) + "offset"),
      largest_offset_(checked_number(spec, "offset", 0)),
      view_(setup, surroundings) {
  const std::string name = stream_name(setup, spec);
  for (Entity* entity : looked_at(setup, spec, surroundings)) {
    targets_.push_back({seen(setup.of(*entity), view_.scene()),
                        {surroundings.seed, name + entity->name() + "/errors"},
                        {surroundings.seed, name + entity->name() + "/misses"}});
  }
  draw_offset();
}

void Detector::draw_offset() noexcept {
  const auto number = [&](std::uint64_t n) { return offsets_.uniform(n, -largest_offset_, largest_offset_); };
  offset_ = {number(0), number(1), number(2)};
}

void Detector::draw_anew(std::uint64_t seed) {
  offsets_.reseed(seed);
  draw_offset();
  for (Target& target : targets_) {
    target.errors.reseed(seed);
    target.misses.reseed(seed);
  }
}

Detector::Polar Detector::polar(const Vec3d& place) noexcept {
  return {norm(place), std::atan2(place.y, place.x), std::atan2(place.z, std::hypot(place.x, place.y))};
}

bool Detector::sees(const Target& target, const Polar& place, collision::QueryScene& scene) const noexcept {
  if (!target.seen.entity->present()) return false;
  if (place.distance < numbers_.range.min || place.distance > numbers_.range.max) return false;
  if (abs(place.azimuth) > numbers_.half_azimuth || abs(place.elevation) > numbers_.half_elevation) return false;
  if (numbers_.misses > 0 && target.misses.uniform(looks_) < numbers_.misses) return false;
  return is_in_sight(scene, mounting_.position(), &robot_, target.seen, numbers_.visible_share);
}

Detector::Polar Detector::with_errors(const Target& target, Polar place) const noexcept {
  if (numbers_.distance_noise > 0) {
    place.distance *= std::max(1 + numbers_.distance_noise * target.errors.normal(3 * looks_), 0.0);
  }
  if (numbers_.azimuth_noise > 0) {
    place.azimuth += numbers_.azimuth_noise * target.errors.normal(3 * looks_ + 1);
    place.azimuth = std::remainder(place.azimuth, 2 * pi);
  }
  if (numbers_.elevation_noise > 0) place.elevation += numbers_.elevation_noise * target.errors.normal(3 * looks_ + 2);
  return place;
}

void Detector::measure(std::span<double> values) noexcept {
  collision::QueryScene& scene = view_.now();
  const Vec3d eye = mounting_.position();
  const Mat3d axes = mounting_.orientation();
  double* value = values.data();
  for (const Target& target : targets_) {
    const Vec3d place = transposed_times(axes, target.seen.r[0] - eye);
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    const Polar shown = sees(target, polar(place), scene) ? with_errors(target, polar(place + offset_))
                                                          : Polar{nothing, nothing, nothing};
    *value++ = shown.distance;
    *value++ = shown.azimuth;
    *value++ = shown.elevation;
  }
  ++looks_;
}

}  // namespace murosimf::sensors
