/// sensor_types.h - names of sensors in files, and how to attach them.
///
/// A new sensor is one more line in sensor_types.cpp; programs and plug-ins add to the registry.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "murosimf/model/option.h"
#include "murosimf/model/registry.h"
#include "murosimf/runtime/simulation.h"
#include "murosimf/sensors/sensor.h"

namespace murosimf::component_files {

struct SensorType {
  std::string name, meaning;
  std::string objects;  ///< key of SensorSpec::objects: "joints", "bodies", "entities"; empty: none
  sensors::Watch watch;
  std::function<std::unique_ptr<sensors::Sensor>(Setup&, const sensors::SensorSpec&,
                                                 const sensors::SensorSurroundings&)>
      make;
  std::vector<OptionInfo> options{};  ///< keys of its own: the table that reads them (sensors/sensor_options.h)
};

/// Types of the library in alphabetical order, then added ones.
[[nodiscard]] Registry<SensorType>& sensor_registry();
/// The same, read-only.
[[nodiscard]] const Registry<SensorType>& sensor_types();

/// Attaches the sensor to a robot. Throws SetupError with the spec's place in its file: unknown type, frame or object,
/// impossible rate or number, a name that another sensor of the robot has.
sensors::Sensor& attach_sensor(Simulation& simulation, Entity& robot, const sensors::SensorSpec& spec,
                               const sensors::SensorSurroundings& surroundings, double step_rate);

}  // namespace murosimf::component_files
