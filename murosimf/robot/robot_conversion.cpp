#include "murosimf/robot/robot_conversion.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/components/sensor_sections.h"
#include "murosimf/components/servo_sections.h"
#include "murosimf/files/input_file.h"
#include "murosimf/formats/mjcf/mjcf_sensor.h"
#include "murosimf/formats/mjcf/mjcf_writer.h"
#include "murosimf/robot/robot_config.h"
#include "murosimf/robot/robot_formats.h"
#include "murosimf/robot/robot_reader.h"
#include "murosimf/robot/role_inference.h"

namespace murosimf::robot {
namespace {

namespace fs = std::filesystem;

/// With all of the bodies of the file: read_robot has welded those that do not move.
description::RobotDescription read_all_bodies(const fs::path& file, description::ReaderOptions options) {
  for (const TableName& mesh : read_table_beside(file).part_per_group) options.part_per_group.push_back(mesh.name);
  return format_of(file).read(file, options);
}

/// Sensors of the robot file that MJCF has no word for. `description`: as it is written, with the same sensors as the robot's.
std::vector<sensors::SensorSpec> sensors_for_table(const RobotFile& robot,
                                                   const description::RobotDescription& description,
                                                   std::vector<std::string>& warnings) {
  std::vector<sensors::SensorSpec> specs;
  for (std::size_t i = 0; i < description.sensors.size(); ++i) {
    const std::string& name = robot.description.sensors[i].becomes;
    const auto spec = std::ranges::find(robot.sensors, name, &sensors::SensorSpec::name);
    if (name.empty() || spec == robot.sensors.end() ||
        formats::mjcf::is_mjcf_sensor(description.sensors[i], description))
      continue;
    const auto table = std::ranges::find(robot.table.sensors, name, &components::SensorTable::name);
    if (table == robot.table.sensors.end()) {
      specs.push_back(*spec);
    } else if (!table->values.contains("type")) {
      warnings.push_back(fmt::format("{}: sensor '{}' needs a type now: MJCF has no word for the one that this changes",
                                     table->where, name));
    }
  }
  return specs;
}

/// Who reads the MJCF file alone gets the gains that are simulated: those of the table.
void take_gains(const RobotConfig& table, description::RobotDescription& description) {
  for (description::BodyDescription& body : description.bodies) {
    for (description::JointDescription& joint : body.joints) {
      const auto found = table.servos.find(joint.name);
      if (!joint.servo || found == table.servos.end() || !(found->second.servo.position_gain > 0)) continue;
      joint.servo->position_gain = found->second.servo.position_gain;
    }
  }
}

/// The largest rates of joints, for which MJCF has no word, as a section of the table, which has none.
std::string rate_limits_toml(const description::RobotDescription& description) {
  std::string text;
  for (const description::BodyDescription& body : description.bodies) {
    for (const description::JointDescription& joint : body.joints) {
      if (joint.rate_limit > 0) text += fmt::format("{} = {}\n", components::toml_quoted(joint.name), joint.rate_limit);
    }
  }
  return text.empty() ? "" : "\n[rate_limits]  # [rad/s | m/s]\n" + text;
}

void count(const description::RobotDescription& description, RobotConversion& result) {
  result.bodies = static_cast<int>(description.bodies.size());
  for (const description::BodyDescription& body : description.bodies) {
    result.joints += static_cast<int>(body.joints.size());
    result.mass += body.solid.mass;
  }
}

}  // namespace

RobotConversion convert_robot(const fs::path& file, const ConversionOptions& options) {
  RobotConversion result;
  const RobotFile robot = read_robot(file, options.reader);
  result.warnings = robot.warnings;
  description::RobotDescription description = read_all_bodies(file, options.reader);
  take_gains(robot.table, description);
  if (options.fit) result.fits = fit_meshes(description, *options.fit);
  count(description, result);
  result.mjcf = formats::mjcf::to_mjcf(description, {options.folder});
  fs::path table = file;
  table.replace_extension(".toml");
  std::error_code none;
  result.own_table = fs::exists(table, none);
  result.toml = result.own_table ? files::read_input_file(table, files::most_toml_bytes)
                                 : roles_toml(robot.description, robot.table);
  if (robot.table.rate_limits.empty()) {
    result.toml += rate_limits_toml(description);
  } else if (!rate_limits_toml(description).empty()) {
    result.warnings.push_back(fmt::format("{}: largest rates of other joints than those of the table are left out",
                                          description.bodies[0].where));
  }
  result.toml += components::sensor_sections(sensors_for_table(robot, description, result.warnings));
  return result;
}

}  // namespace murosimf::robot
