#include "murosimf/sensors/world_queries.h"

#include "murosimf/model/properties.h"

namespace murosimf::sensors {

namespace {

void read_pose(Setup& setup) {
  (void)setup.read(properties::position);
  (void)setup.read(properties::orientation);
}

void read_poses(const Setup& setup, const std::vector<Entity*>& entities) {
  for (Entity* entity : entities) {
    Setup other = setup.of(*entity);
    read_pose(other);
  }
}

}  // namespace

WorldQueries::WorldQueries(Setup& setup, const std::vector<Entity*>& moving_entities)
    : world_(setup.world()), common_(setup.entity()) {
  (void)setup.write(query_turn);
  read_poses(setup, moving_entities);
}

collision::QueryScene& WorldQueries::scene(const Setup& setup, const std::string& volume) {
  (void)setup.of(common_).read(query_turn);
  const auto found = scenes_.find(volume);
  if (found != scenes_.end()) return *found->second;
  return *scenes_.emplace(volume, std::make_unique<collision::QueryScene>(world_, volume)).first->second;
}

void WorldQueries::entity_added(Setup& setup) {
  read_pose(setup);
  for (const auto& [volume, scene] : scenes_) scene->add(setup.entity());
}

void WorldQueries::entity_taken_back(const Entity& entity) noexcept {
  for (const auto& [volume, scene] : scenes_) scene->take_back(entity);
}

void WorldQueries::model_exchanged(const Entity& entity) {
  for (const auto& [volume, scene] : scenes_) scene->model_exchanged(entity);
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

void WorldView::add(Setup& setup) {
  read_pose(setup);
  if (own_) own_->add(setup.entity());
}

void WorldView::take_back(const Entity& entity) noexcept {
  if (own_) own_->take_back(entity);
}

void WorldView::model_exchanged(const Entity& entity) {
  if (own_) own_->model_exchanged(entity);
}

collision::QueryScene& WorldView::now() noexcept {
  if (own_) own_->refresh();
  return *scene_;
}

void read_motion(Setup& setup) {
  read_pose(setup);
  (void)setup.read(properties::linear_velocity);
  (void)setup.read(properties::angular_velocity);
}

void read_motion_of_all(Setup& setup, const SensorSurroundings& surroundings) {
  for (Entity* moving_entity : surroundings.moving_entities) {
    Setup other = setup.of(*moving_entity);
    read_motion(other);
  }
}

}  // namespace murosimf::sensors
