/// sonar.h - sensors: the nearest thing in a cone, and on a single ray.
///
/// Output `range` [m]: the distance of the nearest surface on any of `rays` rays, exact for all shapes that collide;
/// the robot that carries the sensor is transparent. Nothing within the range is +infinity, something nearer than
/// `range_min` -infinity (ROS REP-117).
///
/// A sonar looks along x of the sensor into a cone of `fov`, from side to side. Its first ray is the axis; ray k of
/// the other n - 1 has the angle a from the axis and the angle b about it,
///
///     cos a = 1 - (1 - cos(fov / 2)) k / (n - 1),   b = k pi (3 - sqrt(5)),
///
/// so that each ray stands for an equal part of the cone and the last one is at its edge. A thing that is smaller than
/// the gaps between rays may be missed; how surfaces reflect sound is not modeled.
/// Source of the spiral: Vogel, "A better way to construct the sunflower head", Math. Biosciences 44 (1979).
///
/// A range finder is one ray along z of the sensor, as MJCF has it. Unlike there, nothing found is +infinity, not -1,
/// and all of the robot is transparent, not only the body that the sensor is fixed to.
///
/// Options of the sonar: SonarOptions, of the range finder: RangeFinderOptions.
#pragma once

#include "murosimf/sensors/mounting.h"
#include "murosimf/sensors/range.h"
#include "murosimf/sensors/sensor.h"
#include "murosimf/sensors/sensor_options.h"
#include "murosimf/sensors/world_queries.h"

namespace murosimf::sensors {

struct SonarOptions {
  int rays = 61;
  double fov = 15 * pi / 180;  ///< [rad]
  Range range{.min = 0.02, .max = 4};
};

struct RangeFinderOptions {
  Range range{};
};

[[nodiscard]] const OptionTable<SonarOptions>& sonar_options();
[[nodiscard]] const OptionTable<RangeFinderOptions>& rangefinder_options();

/// The nearest surface on any of some rays.
class NearestOfRays : public Sensor {
 protected:
  /// `directions`: of the rays, unit vectors in axes of the sensor. Throws SetupError if the range is impossible.
  NearestOfRays(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings,
                std::vector<Vec3d> directions, const Range& range);

  void entity_added(Setup& setup) override { view_.add(setup); }
  void entity_taken_back(const Entity& entity) noexcept override { view_.take_back(entity); }
  void model_exchanged(const Entity& entity) override { view_.model_exchanged(entity); }

 private:
  void measure(std::span<double> values) noexcept override;
  void present(std::span<double> values) noexcept override;

  const Entity& robot_;
  Mounting mounting_;
  Range range_;
  std::vector<Vec3d> directions_;
  WorldView view_;
};

class Sonar final : public NearestOfRays {
 public:
  /// Throws SetupError that names the number that is impossible.
  Sonar(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings);
};

class RangeFinder final : public NearestOfRays {
 public:
  /// Throws SetupError that names the number that is impossible.
  RangeFinder(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings);
};

}  // namespace murosimf::sensors
