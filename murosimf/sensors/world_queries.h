/// world_queries.h - what sensors with rays see: everything that collides, with the poses of this instant.
#pragma once

#include "murosimf/collision/queries.h"
#include "murosimf/model/setup.h"
#include "murosimf/sensors/sensor_spec.h"

namespace murosimf::sensors {

/// Reads the poses of all moving entities. Volumes are of the kind that the robot's own collisions use. The scene is to be
/// refreshed before questions are asked.
[[nodiscard]] collision::QueryScene world_queries(Setup& setup, const SensorSurroundings& surroundings);

/// Declares that poses and velocities of all moving entities are read: what whoever draws them needs (view_source.h).
void read_motion_of_all(Setup& setup, const SensorSurroundings& surroundings);

}  // namespace murosimf::sensors
