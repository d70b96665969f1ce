/// new_name.h - sensor `new_name`: its height.
///
/// Output `height` [m]: of the sensor above the plane z = 0, world frame, whatever it is mounted on.
///
///     height = e_z . r      r: place of the sensor, world
///
/// This place is for the equations of a sensor, their source (a paper, a data sheet) and what it does not model. Rate, delay, noise,
/// filter, saturation and conversion are part of the base class (sensor.h).
#pragma once

#include "murosimf/sensors/mounting.h"
#include "murosimf/sensors/sensor.h"

namespace murosimf::sensors {

class NewName final : public Sensor {
 public:
  NewName(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings);

 private:
  void measure(std::span<double> values) noexcept override;

  Mounting mounting_;
};

}  // namespace murosimf::sensors
