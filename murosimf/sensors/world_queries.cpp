#include "murosimf/sensors/world_queries.h"

#include "murosimf/model/properties.h"

namespace murosimf::sensors {

namespace {

void read_poses_of_all(Setup& setup, const SensorSurroundings& surroundings) {
  for (Entity* moving_entity : surroundings.moving_entities) {
    Setup other = setup.of(*moving_entity);
    (void)other.read(properties::position);
    (void)other.read(properties::orientation);
  }
}

}  // namespace

collision::QueryScene world_queries(Setup& setup, const SensorSurroundings& surroundings) {
  read_poses_of_all(setup, surroundings);
  return collision::QueryScene(setup.world(), setup.entity().options().collision.volume);
}

void read_motion_of_all(Setup& setup, const SensorSurroundings& surroundings) {
  read_poses_of_all(setup, surroundings);
  for (Entity* moving_entity : surroundings.moving_entities) {
    Setup other = setup.of(*moving_entity);
    (void)other.read(properties::linear_velocity);
    (void)other.read(properties::angular_velocity);
  }
}

}  // namespace murosimf::sensors
