#include "murosimf/sensors/world_queries.h"

#include "murosimf/model/properties.h"

namespace murosimf::sensors {

namespace {

void read_poses(Setup& setup, const std::vector<Entity*>& entities) {
  for (Entity* entity : entities) {
    Setup other = setup.of(*entity);
    (void)other.read(properties::position);
    (void)other.read(properties::orientation);
  }
}

}  // namespace

WorldQueries::WorldQueries(Setup& setup, const std::vector<Entity*>& moving_entities)
    : world_(setup.world()), environment_(setup.entity()) {
  (void)setup.write(query_turn);
  read_poses(setup, moving_entities);
}

collision::QueryScene& WorldQueries::scene(const Setup& setup, const std::string& volume) {
  (void)setup.of(environment_).read(query_turn);
  const auto found = scenes_.find(volume);
  if (found != scenes_.end()) return *found->second;
  return *scenes_.emplace(volume, std::make_unique<collision::QueryScene>(world_, volume)).first->second;
}

void WorldQueries::refresh() noexcept {
  for (const auto& [volume, scene] : scenes_) scene->refresh();
}

WorldView::WorldView(Setup& setup, const SensorSurroundings& surroundings) {
  read_poses(setup, surroundings.moving_entities);
  const std::string& volume = setup.entity().options().collision.volume;
  if (surroundings.queries) {
    scene_ = &surroundings.queries().scene(setup, volume);
  } else {
    own_ = std::make_unique<collision::QueryScene>(setup.world(), volume);
    scene_ = own_.get();
  }
}

collision::QueryScene& WorldView::now() noexcept {
  if (own_) own_->refresh();
  return *scene_;
}

void read_motion_of_all(Setup& setup, const SensorSurroundings& surroundings) {
  read_poses(setup, surroundings.moving_entities);
  for (Entity* moving_entity : surroundings.moving_entities) {
    Setup other = setup.of(*moving_entity);
    (void)other.read(properties::linear_velocity);
    (void)other.read(properties::angular_velocity);
  }
}

}  // namespace murosimf::sensors
