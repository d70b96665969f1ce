/// ground_truth.h - sensor: true poses of the entities (paper 6.3), for behavior tests without perception.
///
/// Three outputs for each entity that it looks at (SensorSpec::objects; none named: all robots and the ball):
/// `<entity>_position` [m], `<entity>_heading` [rad] and `<entity>_velocity` [m/s] of the base, world frame. Nothing
/// hides anything; noise, rate and delay are those of any sensor. Numbers of one that is not there are NaN.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "murosimf/sensors/sensor.h"

namespace murosimf::sensors {

class GroundTruth final : public Sensor {
 public:
  /// Throws SetupError if the spec names an entity that does not move, or that there is none of.
  GroundTruth(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings);

 private:
  struct Source {
    const Entity* entity;
    std::span<const Vec3d> r, v;
    std::span<const Mat3d> R;
  };
  void measure(std::span<double> values) noexcept override;

  std::vector<Source> sources_;
};

/// The entities of `surroundings` that a sensor looks at: those that the spec names, or all. Throws SetupError with the
/// nearest name.
[[nodiscard]] std::vector<Entity*> sensed_entities(const SensorSpec& spec, const SensorSurroundings& surroundings);

/// One entity as ground truth shows it.
struct Sighting {
  std::string name;
  std::string team;   ///< empty for things that play in no team
  bool self = false;  ///< the robot that carries the sensor
  bool present = true;
  Vec3d position;      ///< [m] of the base, world frame
  double heading = 0;  ///< [rad] of the base about the vertical, world frame
  Vec3d velocity;      ///< [m/s] of the base, world frame
};

/// Ground truth for control software: in its constructor it names the sensor, in each step it looks.
class Sightings {
 public:
  /// Throws SetupError if the robot has no such sensor.
  explicit Sightings(Setup& setup, std::string_view sensor = "ground_truth");
  /// As the sensor shows them now.
  [[nodiscard]] const std::vector<Sighting>& look() noexcept;

 private:
  const Reading& reading_;
  std::vector<Sighting> sightings_;
};

}  // namespace murosimf::sensors
