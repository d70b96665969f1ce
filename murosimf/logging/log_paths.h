/// log_paths.h - which numbers of a simulation the patterns of --log mean.
///
///     blue1.imu.gyroscope.x            one number of a sensor: entity, sensor, output, label
///     blue*.encoders                   * and ? match within a part; what is left out at the end means all below
///     blue.*.imu                       of a team's robots, as for --set
///     blue1.joint_torque               a property of joints: of all of them
///     blue1.l_foot.external_force      a property of an object, where no sensor has that path
#pragma once

#include <string>
#include <vector>

#include "murosimf/model/world.h"

namespace murosimf::logging {

/// One number that can be logged.
struct LoggedNumber {
  Entity* entity = nullptr;
  std::string sensor;             ///< empty: it is of a property
  int object = 0;                 ///< of a property
  std::string property;           ///< likewise
  std::size_t index = 0;          ///< among the sensor's or the property's numbers
  std::vector<std::string> path;  ///< parts of its name
  std::string unit;
  [[nodiscard]] std::string name() const;  ///< "blue1.imu.gyroscope.x [rad/s]"
};

/// What the patterns mean, each number once: in their order, then that of entities, of objects, and of names. To be called
/// when all algorithms are attached. Throws SetupError for a pattern that means nothing: what is unknown in it,
/// with the nearest name.
[[nodiscard]] std::vector<LoggedNumber> find_logged(const World& world, const std::vector<std::string>& patterns);

}  // namespace murosimf::logging
