/// laser.h - sensor: a laser range finder that scans a plane.
///
/// Its rays lie in the x-y plane of the sensor. The first one points at `first_angle` from x towards y, the others
/// follow counterclockwise, evenly over `opening`; a full circle of n rays has the opening 2 pi (n - 1) / n. Output
/// `ranges` [m], labels "0" to "n-1": the distance of the first surface on each ray, exact for all shapes that collide;
/// the robot that carries the sensor is transparent. Nothing within the range is +infinity, something nearer than
/// `nearest` -infinity, both before and after errors are added. All rays of a scan are of one instant: a part that
/// turns takes a scan's time for it.
/// Source: what infinities mean: ROS REP-117, Informational Distance Measurements.
///
/// depth_laser.h is the same by pictures of depths.
///
/// Numbers: rays (1081), opening (4.71238898 rad = 270 deg), first_angle (-opening / 2 rad), nearest (0.06 m),
/// farthest (30 m).
#pragma once

#include "murosimf/sensors/all_around.h"
#include "murosimf/sensors/laser_fan.h"
#include "murosimf/sensors/mounting.h"
#include "murosimf/sensors/sensor.h"

namespace murosimf::sensors {

class Laser final : public Sensor {
 public:
  /// Throws SetupError that names the number that is impossible.
  Laser(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings);

 private:
  void measure(std::span<double> values) noexcept override;
  void present(std::span<double> values) noexcept override;

  const Entity& robot_;
  Mounting mounting_;
  Range range_;
  collision::Fan fan_;
  collision::QueryScene scene_;
};

}  // namespace murosimf::sensors
