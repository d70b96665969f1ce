#include "murosimf/sensors/all_around.h"

#include "murosimf/model/properties.h"

namespace murosimf::sensors {

namespace {

void read_poses_of_all(Setup& setup, const SensorSurroundings& surroundings) {
  for (Entity* mover : surroundings.movers) {
    Setup other = setup.of(*mover);
    (void)other.read(properties::position);
    (void)other.read(properties::orientation);
  }
}

}  // namespace

collision::QueryScene all_around(Setup& setup, const SensorSurroundings& surroundings) {
  read_poses_of_all(setup, surroundings);
  return collision::QueryScene(setup.world(), setup.entity().options().collision.volume);
}

void read_motion_of_all(Setup& setup, const SensorSurroundings& surroundings) {
  read_poses_of_all(setup, surroundings);
  for (Entity* mover : surroundings.movers) {
    Setup other = setup.of(*mover);
    (void)other.read(properties::linear_velocity);
    (void)other.read(properties::angular_velocity);
  }
}

}  // namespace murosimf::sensors
