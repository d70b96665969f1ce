/// log_paths.h - numbers of a simulation that the patterns of --log denote.
///
///     blue1.imu.gyroscope.x            one number of a sensor: entity, sensor, output, label
///     blue*.encoders                   * and ? match within a part; a missing rest denotes everything below
///     blue.*.imu                       of a team's robots, as for --set
///     blue1.joint_torque               a property of joints: of all of them
///     blue1.l_foot.external_force      a property of an object, where no sensor has that path
#pragma once

#include <string>
#include <vector>

#include "murosimf/world/world.h"

namespace murosimf::logging {

/// One number that can be logged.
struct LoggedNumber {
  Entity* entity = nullptr;
  std::string sensor;             ///< empty: it belongs to a property
  int object = 0;                 ///< of a property
  std::string property;           ///< likewise
  std::size_t index = 0;          ///< among the sensor's or the property's numbers
  std::vector<std::string> path;  ///< parts of its name
  std::string unit;
  [[nodiscard]] std::string name() const;  ///< "blue1.imu.gyroscope.x [rad/s]"
};

/// Numbers that the patterns denote, each once: in their order, then in the order of entities, of objects, and of names. Call
/// when all algorithms are attached. Throws SetupError for a pattern without a number: the unknown part,
/// with the nearest name.
[[nodiscard]] std::vector<LoggedNumber> find_logged(const World& world, const std::vector<std::string>& patterns);
/// Those of one that has come to the world; none, if no pattern denotes any.
[[nodiscard]] std::vector<LoggedNumber> find_logged(Entity& newcomer, const std::vector<std::string>& patterns);
/// Whether an entity of the world has a name as the pattern says.
[[nodiscard]] bool denotes_entity(const World& world, const std::string& pattern);

}  // namespace murosimf::logging
