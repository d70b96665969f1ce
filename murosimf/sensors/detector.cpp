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

const OptionTable<DetectorOptions>& detector_options() {
  using Options = DetectorOptions;
  static const OptionTable<Options> table{
      {"fov_azimuth", &Options::fov_azimuth, "rad", "field of view, from left to right", 0, widest_fov},
      {"fov_elevation", &Options::fov_elevation, "rad", "field of view, from top to bottom", 0, pi + rounding},
      range_min_row<Options>(),
      range_max_row<Options>(),
      {"visible_share", &Options::visible_share, "1", "of nine points of a body that must be free; at least one", 0, 1},
      {"misses", &Options::misses, "1", "probability that a thing in sight is not reported", 0, 1},
      {"distance_noise", &Options::distance_noise, "1", "deviation of each report, per meter of distance", 0},
      {"azimuth_noise", &Options::azimuth_noise, "rad", "deviation of each report", 0},
      {"elevation_noise", &Options::elevation_noise, "rad", "deviation of each report", 0},
      {"offset", &Options::offset, "m", "largest constant error of the place along each axis, drawn once per run", 0},
  };
  return table;
}

Detector::Detector(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings)
    : Sensor(setup, spec, surroundings, detections(looked_at(setup, spec, surroundings))),
      robot_(setup.entity()),
      mounting_(setup, spec),
      options_(options_of(spec, detector_options())),
      offsets_(surroundings.seed, stream_name(setup, spec) + "offset"),
      view_(setup, surroundings) {
  (void)checked(options_.range);
  const std::string name = stream_name(setup, spec);
  for (Entity* entity : looked_at(setup, spec, surroundings)) {
    targets_.push_back({seen(setup.of(*entity), view_.scene()),
                        {surroundings.seed, name + entity->name() + "/errors"},
                        {surroundings.seed, name + entity->name() + "/misses"}});
  }
  draw_offset();
}

void Detector::model_exchanged(const Entity& entity) {
  view_.model_exchanged(entity);
  for (Target& target : targets_) {
    if (target.seen.entity == &entity) target.seen.shapes = view_.scene().shapes(entity);
  }
}

void Detector::draw_offset() noexcept {
  const auto number = [&](std::uint64_t n) { return offsets_.uniform(n, -options_.offset, options_.offset); };
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
  if (place.distance < options_.range.min || place.distance > options_.range.max) return false;
  if (abs(place.azimuth) > 0.5 * options_.fov_azimuth) return false;
  if (abs(place.elevation) > 0.5 * options_.fov_elevation) return false;
  if (options_.misses > 0 && target.misses.uniform(looks_) < options_.misses) return false;
  return is_in_sight(scene, mounting_.position(), &robot_, target.seen, options_.visible_share);
}

Detector::Polar Detector::with_errors(const Target& target, Polar place) const noexcept {
  if (options_.distance_noise > 0) {
    place.distance *= std::max(1 + options_.distance_noise * target.errors.normal(3 * looks_), 0.0);
  }
  if (options_.azimuth_noise > 0) {
    place.azimuth += options_.azimuth_noise * target.errors.normal(3 * looks_ + 1);
    place.azimuth = std::remainder(place.azimuth, 2 * pi);
  }
  if (options_.elevation_noise > 0) place.elevation += options_.elevation_noise * target.errors.normal(3 * looks_ + 2);
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
