/// sensor_table.h - tables [sensors.NAME] of TOML files, and how they make and change sensors.
///
///     [sensors.imu]
///     type = "imu"               # component_files/sensor_types.h; with it the table is a sensor of its own, without it changes one
///     frame = "imu"              # object of the model that it is mounted on; default: the base
///     position = [0, 0, 0.02]    # [m] in that frame; rpy_deg = [0, 0, 90]: roll, pitch, yaw of its axes
///     mounting_error_deg = [0.2, -3.8, 3.7]  # by which its true axes are turned from these: roll, pitch, yaw
///     part = "mpu6050"           # a ready-made part to start from: parts/mpu6050.toml, or a file beside this one
///     rate = 500                 # [Hz] of samples; without it: one in every step
///     delay = 0.002              # [s] from the sample until control software can read it
///     [sensors.imu.gyroscope]    # errors of the true values, by output (sensors/signal_spec.h)
///     range = 34.9               # short for lowest = -34.9, highest = 34.9
///     noise_density = 1e-4
///
/// Keys of SensorType::options and objects stand beside these. Keys of signals may stand directly in
/// [sensors.NAME]: they apply to all outputs. NAME = false removes a sensor.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "murosimf/sensors/sensor_spec.h"

namespace murosimf::component_files {

/// The value of a key, and where it is written: "robot.toml:3:8".
struct SensorValue {
  std::variant<bool, double, std::string, std::vector<double>, std::vector<std::string>> is;
  std::string where;
};

using SensorValues = std::map<std::string, SensorValue>;

/// One table of a file, unchecked.
struct SensorTable {
  std::string name, where;
  bool removes = false;  ///< NAME = false
  SensorValues values;
  std::map<std::string, SensorValues> outputs;
};

/// Changes that a scene makes to the sensors of a robot's files.
struct SensorChanges {
  bool none = false;  ///< removes all of them first
  std::vector<SensorTable> tables;
};

/// Makes, changes and removes sensors by the tables, one after the other. A table with `type` replaces a
/// sensor of that name. `part` replaces all earlier signals and numbers by those of the part; the table's own keys
/// precede the part's. Parts are also searched for in `beside`. Throws SetupError with file:line:column.
void change_sensors(std::vector<sensors::SensorSpec>& sensors, const std::vector<SensorTable>& tables,
                    const std::filesystem::path& beside);

/// Whether the name consists of letters, digits, _ and -: it can stand in "robot.sensor.output".
[[nodiscard]] bool is_sensor_name(std::string_view name);

/// All parts that come with the program, in alphabetical order.
[[nodiscard]] std::vector<std::string> sensor_parts();

}  // namespace murosimf::component_files
