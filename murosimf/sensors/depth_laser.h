/// depth_laser.h - sensor: a laser range finder whose distances come from pictures of depths, drawn as cameras' are.
///
/// The second algorithm for the sensor of laser.h, with the same numbers and output. It sees what is drawn, meshes for
/// the eye too, where the other one meets what collides. Up to 80 degrees of the fan are one row of a picture; a ray
/// between two pixels of one surface takes 1 / z from both, which is exact on planes, and the nearer pixel's at an edge:
///
///     range = z / cos(a)         z: depth, a: angle of the ray from the middle of its picture
///
/// Without a source of pictures (docs/cameras.md) all ranges are NaN.
#pragma once

#include <functional>
#include <vector>

#include "murosimf/sensors/laser_fan.h"
#include "murosimf/sensors/mounting.h"
#include "murosimf/sensors/sensor.h"
#include "murosimf/sensors/view_source.h"
#include "murosimf/sensors/world_queries.h"

namespace murosimf::sensors {

class DepthLaser final : public Sensor {
 public:
  /// Throws SetupError that names the number that is impossible.
  DepthLaser(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings);

  void entity_added(Setup& setup) override { read_motion(setup); }

 private:
  /// Where a ray is in a row of depths.
  struct Tap {
    std::size_t row = 0;
    double u = 0;        // [px]
    double stretch = 1;  // [1] range of depth 1
  };

  void measure(std::span<double> values) noexcept override;
  void present(std::span<double> values) noexcept override;
  void start() override;
  void look() noexcept;

  const Entity& robot_;
  Mounting mounting_;
  Range range_;
  std::function<ViewSource*()> find_source_;
  ViewSource* source_ = nullptr;
  std::vector<Perspective> rows_;  // in axes of the sensor, at its place
  std::vector<View> views_;
  std::vector<Tap> taps_;  // by ray
};

}  // namespace murosimf::sensors
