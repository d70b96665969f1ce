/// reading.h - what a sensor shows: its last sample, by name, with the instant at which that was taken.
///
///     sensors::find_reading(robot, "imu")->output("gyroscope");         // anywhere, once
///     gyro_ = sensors::read_output(setup, "imu.gyroscope");             // an algorithm, in its constructor
///
/// A reading stands in a column of the robot, `sensor.<name>`, which is not part of the state hash: looking changes
/// nothing. hash_of is the readings' own.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/math/mat3.h"
#include "murosimf/world/setup.h"

namespace murosimf::sensors {

/// One quantity of a sensor: one number, or a row of numbers with labels.
struct Output {
  std::string name{};                 ///< "gyroscope"
  std::string unit{};                 ///< SI
  std::vector<std::string> labels{};  ///< "x", "y", "z"; none: a single number
  /// What else its readers need: of the ranges of a laser first_angle, fov [rad], range_min and range_max [m].
  std::map<std::string, double> constants{};
  [[nodiscard]] std::size_t size() const { return labels.empty() ? 1 : labels.size(); }
};

/// What does not change while the sensor runs.
struct SensorInfo {
  std::string name{};   ///< unique on its robot
  std::string type{};   ///< as in files: "imu"
  std::string frame{};  ///< name of the object that it is mounted on; empty: nothing in particular
  Duration period{};    ///< between two samples
  std::vector<Output> outputs{};
  Mat3d orientation{};  ///< its axes, as it is meant to be mounted, to those of the frame
  Vec3d position{};     ///< [m] of it in the frame
  [[nodiscard]] std::size_t numbers() const;
};

struct Reading {
  Duration time{};             ///< simulated, at which the sample was taken; its numbers may have come later
  std::uint64_t samples = 0;   ///< that have come so far; 0: none, values are 0, or (inertial.h) as at rest
  std::vector<double> values;  ///< of all outputs, one after the other; never moves. NaN: nothing seen
  std::shared_ptr<const SensorInfo> info;

  /// Throws SetupError with the nearest name.
  [[nodiscard]] std::span<const double> output(std::string_view name) const;
};

void append_hash(Hasher& hasher, const Reading& reading);
void state(StateArchive& archive, Reading& reading);

/// Hash of the present sample: its instant and numbers.
[[nodiscard]] std::uint64_t hash_of(const Reading& reading);

/// For the sensor itself: creates its reading. Throws SetupError if the robot has a sensor of that name.
[[nodiscard]] Reading& write_reading(Setup& setup, SensorInfo info);

/// For algorithms of the robot, in their constructors. The sensor must be attached before. Throws SetupError with the
/// nearest name if there is none.
[[nodiscard]] const Reading& read_reading(Setup& setup, std::string_view sensor);
/// The same for one output, "imu.gyroscope", or the only one of a sensor, "battery". Stays valid.
[[nodiscard]] std::span<const double> read_output(Setup& setup, std::string_view path);

/// Null if there is none.
[[nodiscard]] const Reading* find_reading(const Entity& entity, std::string_view sensor);
/// Those of all sensors of an entity, in the order of their names.
[[nodiscard]] std::vector<const Reading*> readings_of(const Entity& entity);

/// Labels of a vector's numbers.
inline std::vector<std::string> xyz() { return {"x", "y", "z"}; }

inline void write(const Vec3d& v, std::span<double> values) noexcept {
  values[0] = v.x;
  values[1] = v.y;
  values[2] = v.z;
}

inline Vec3d vector_of(std::span<const double> values) noexcept { return {values[0], values[1], values[2]}; }

}  // namespace murosimf::sensors
