/// laser.h - sensor: a laser range finder that scans a plane.
///
/// Its rays lie in the x-y plane of the sensor. The first one points at `first_angle` from x towards y, the others
/// follow counterclockwise, evenly over `fov`; a full circle of n rays has the fov 2 pi (n - 1) / n. Output
/// `ranges` [m], labels "0" to "n-1": the distance of the first surface on each ray, exact for all shapes that collide;
/// the robot that carries the sensor is transparent. Nothing within the range is +infinity, something nearer than
/// `range_min` -infinity, both before and after errors are added. All rays of a scan are of one instant: a part that
/// turns takes a scan's time for it.
/// Source: what infinities mean: ROS REP-117, Informational Distance Measurements.
///
/// depth_laser.h is the same by pictures of depths.
///
/// Options: laser_fan.h.
#pragma once

#include "murosimf/sensors/laser_fan.h"
#include "murosimf/sensors/mounting.h"
#include "murosimf/sensors/sensor.h"
#include "murosimf/sensors/world_queries.h"

namespace murosimf::sensors {

class Laser final : public Sensor {
 public:
  /// Throws SetupError that names the number that is impossible.
  Laser(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings);

  void entity_added(Setup& setup) override { view_.add(setup); }
  void entity_taken_back(const Entity& entity) noexcept override { view_.take_back(entity); }
  void model_exchanged(const Entity& entity) override { view_.model_exchanged(entity); }

 private:
  void measure(std::span<double> values) noexcept override;
  void present(std::span<double> values) noexcept override;

  const Entity& robot_;
  Mounting mounting_;
  Range range_;
  collision::Fan fan_;
  WorldView view_;
};

}  // namespace murosimf::sensors
