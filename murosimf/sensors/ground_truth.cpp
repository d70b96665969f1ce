#include "murosimf/sensors/ground_truth.h"

#include "murosimf/model/properties.h"

namespace murosimf::sensors {

void append_hash(Hasher& hasher, const GroundTruthData& data) {
  hasher.add(static_cast<std::uint64_t>(data.time.count()));
  for (const Sighting& sighting : data.sightings) {
    murosimf::append_hash(hasher, sighting.position);
    murosimf::append_hash(hasher, sighting.velocity);
    hasher.add(sighting.heading);
  }
}

GroundTruth::GroundTruth(Setup& setup, const std::vector<Entity*>& entities)
    : self_(setup.entity()), data_(setup.write(ground_truth)[0]) {
  for (Entity* entity : entities) {
    Setup other = setup.of(*entity);
    entities_.push_back(entity);
    sources_.push_back({other.read(properties::position), other.read(properties::linear_velocity),
                        other.read(properties::orientation)});
  }
}

void GroundTruth::initialize() {
  data_.sightings.clear();
  for (const Entity* entity : entities_) {
    Sighting sighting;
    sighting.name = entity->name();
    sighting.team = entity->options().team;
    sighting.self = entity == &self_;
    data_.sightings.push_back(std::move(sighting));
  }
}

void GroundTruth::step(const Instant& instant) noexcept {
  data_.time = instant.now;
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    Sighting& sighting = data_.sightings[i];
    sighting.position = sources_[i].r[0];
    sighting.velocity = sources_[i].v[0];
    sighting.heading = heading(sources_[i].R[0]);
  }
}

}  // namespace murosimf::sensors
