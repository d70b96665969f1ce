#include "murosimf/sensors/ground_truth.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"

namespace murosimf::sensors {
namespace {

constexpr std::string_view position = "_position";
constexpr std::size_t numbers_each = 7;  // position, heading, velocity

std::vector<Output> outputs_for(const std::vector<Entity*>& entities) {
  std::vector<Output> outputs;
  for (const Entity* entity : entities) {
    outputs.push_back({entity->name() + std::string(position), "m", xyz()});
    outputs.push_back({entity->name() + "_heading", "rad", {}});
    outputs.push_back({entity->name() + "_velocity", "m/s", xyz()});
  }
  return outputs;
}

}  // namespace

std::vector<Entity*> sensed_entities(const SensorSpec& spec, const SensorSurroundings& surroundings) {
  if (spec.objects.empty()) return surroundings.moving_entities;
  std::vector<Entity*> entities;
  std::vector<std::string_view> names;
  for (const Entity* moving_entity : surroundings.moving_entities) names.push_back(moving_entity->name());
  for (const std::string& name : spec.objects) {
    // in the order of the sensor's list, not of the scene
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) throw SetupError(unknown_name("entity", name, names));
    entities.push_back(surroundings.moving_entities[static_cast<std::size_t>(found - names.begin())]);
  }
  return entities;
}

GroundTruth::GroundTruth(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings)
    : Sensor(setup, spec, surroundings, outputs_for(sensed_entities(spec, surroundings))) {
  for (Entity* entity : sensed_entities(spec, surroundings)) {
    Setup other = setup.of(*entity);
    sources_.push_back({entity, other.read(properties::position), other.read(properties::linear_velocity),
                        other.read(properties::orientation)});
  }
}

void GroundTruth::measure(std::span<double> values) noexcept {
  MUROSIMF_ASSERT(values.size() == numbers_each * sources_.size());
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    const std::span<double> numbers = values.subspan(numbers_each * i, numbers_each);
    if (!sources_[i].entity->present()) {
      // absent entities: NaN, so that no behavior takes an old place for a present one
      std::fill(numbers.begin(), numbers.end(), std::numeric_limits<double>::quiet_NaN());
      continue;
    }
    write(sources_[i].r[0], numbers);
    numbers[3] = heading(sources_[i].R[0]);
    write(sources_[i].v[0], numbers.subspan(4));
  }
}

Sightings::Sightings(Setup& setup, std::string_view sensor) : reading_(read_reading(setup, sensor)) {
  for (const Output& output : reading_.info->outputs) {
    if (!output.name.ends_with(position)) continue;
    Sighting sighting;
    sighting.name = output.name.substr(0, output.name.size() - position.size());
    // constant during a run, so it is looked up once
    sighting.team = setup.world().entity(sighting.name).options().team;
    sighting.self = sighting.name == setup.entity().name();
    sightings_.push_back(std::move(sighting));
  }
}

const std::vector<Sighting>& Sightings::look() noexcept {
  for (std::size_t i = 0; i < sightings_.size(); ++i) {
    const double* number = &reading_.values[numbers_each * i];
    sightings_[i].present = std::isfinite(number[0]);
    sightings_[i].position = {number[0], number[1], number[2]};
    sightings_[i].heading = number[3];
    sightings_[i].velocity = {number[4], number[5], number[6]};
  }
  return sightings_;
}

}  // namespace murosimf::sensors
