/// sensor_types.h - names of sensors, as files use them, and how to attach what they mean.
///
/// A new sensor is one more line in sensor_types.cpp.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string_view>

#include "murosimf/runtime/simulation.h"
#include "murosimf/sensors/sensor.h"

namespace murosimf::components {

struct SensorType {
  std::string_view name, meaning;
  std::string_view numbers;  ///< keys that only this type has, as in SensorSpec::numbers: "rays fov"
  std::string_view objects;  ///< key of SensorSpec::objects: "joints", "bodies", "entities"; empty: it has none
  sensors::Watch watch;
  std::unique_ptr<sensors::Sensor> (*make)(Setup&, const sensors::SensorSpec&, const sensors::SensorSurroundings&);
  std::string_view flags = {};  ///< keys that are true or false; as SensorSpec::numbers they are 1 or 0
  std::string_view texts = {};  ///< keys of SensorSpec::texts; `calibration` is a file that says several others
};

/// In alphabetical order.
[[nodiscard]] std::span<const SensorType> sensor_types();

/// Attaches the sensor to a robot. Throws SetupError with the spec's place in its file: unknown type, frame or object,
/// impossible rate or number, a name that another sensor of the robot has.
sensors::Sensor& attach_sensor(Simulation& simulation, Entity& robot, const sensors::SensorSpec& spec,
                               const sensors::SensorSurroundings& surroundings, double step_rate);

}  // namespace murosimf::components
