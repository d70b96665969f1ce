#include "murosimf/robot/robot_conversion.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/component_files/sensor_sections.h"
#include "murosimf/component_files/servo_sections.h"
#include "murosimf/files/input_file.h"
#include "murosimf/math/assert.h"
#include "murosimf/robot/conversion_additions.h"
#include "murosimf/robot/conversion_sensors.h"
#include "murosimf/robot/robot_config.h"
#include "murosimf/robot/robot_formats.h"
#include "murosimf/robot/robot_reader.h"
#include "murosimf/robot/robot_soles.h"
#include "murosimf/robot/role_inference.h"
#include "murosimf/robot_formats/mjcf/mjcf_sensor.h"
#include "murosimf/robot_formats/mjcf/mjcf_writer.h"
#include "murosimf/robot_formats/urdf/urdf_writer.h"

namespace murosimf::robot {
namespace {

namespace fs = std::filesystem;

/// With all bodies of the file: read_robot has welded those that do not move.
robot_formats::RobotDescription read_all_bodies(const fs::path& file, robot_formats::ReaderOptions options) {
  for (const TableName& mesh : read_table_beside(file).part_per_group) options.part_per_group.push_back(mesh.name);
  return read_description(file, options);
}

bool has_words_for(WrittenFormat format, const robot_formats::SensorDescription& sensor,
                   const robot_formats::RobotDescription& description) {
  return format == WrittenFormat::urdf ? robot_formats::urdf::is_urdf_sensor(sensor)
                                       : robot_formats::mjcf::is_mjcf_sensor(sensor, description);
}

/// Sensors of the robot file that the format does not have. `description`: as it is written, with the same sensors as the robot's.
std::vector<sensors::SensorSpec> sensors_for_table(WrittenFormat format, const RobotFile& robot,
                                                   const robot_formats::RobotDescription& description,
                                                   std::vector<std::string>& warnings) {
  std::vector<sensors::SensorSpec> specs;
  MUROSIMF_ASSERT(description.sensors.size() >= robot.description.sensors.size());
  for (std::size_t i = 0; i < robot.description.sensors.size(); ++i) {
    const std::string& name = robot.description.sensors[i].becomes;
    const auto spec = std::ranges::find(robot.sensors, name, &sensors::SensorSpec::name);
    if (name.empty() || spec == robot.sensors.end() || has_words_for(format, description.sensors[i], description))
      continue;
    const auto table = std::ranges::find(robot.table.sensors, name, &component_files::SensorTable::name);
    if (table == robot.table.sensors.end()) {
      specs.push_back(*spec);
    } else if (!table->values.contains("type")) {
      warnings.push_back(
          fmt::format("{}: sensor '{}' needs a type now: the new file has no word for the one that this changes",
                      table->where, name));
    }
  }
  return specs;
}

/// The largest rates of joints, which MJCF does not have, as a section of the table.
std::string rate_limits_toml(const robot_formats::RobotDescription& description) {
  std::string text;
  for (const robot_formats::BodyDescription& body : description.bodies) {
    for (const robot_formats::JointDescription& joint : body.joints) {
      if (joint.rate_limit > 0)
        text += fmt::format("{} = {}\n", component_files::toml_quoted(joint.name), joint.rate_limit);
    }
  }
  return text.empty() ? "" : "\n[rate_limits]  # [rad/s | m/s]\n" + text;
}

void count(const robot_formats::RobotDescription& description, RobotConversion& result) {
  result.bodies = static_cast<int>(description.bodies.size());
  for (const robot_formats::BodyDescription& body : description.bodies) {
    result.joints += static_cast<int>(body.joints.size());
    result.mass += body.solid.mass;
  }
}

/// Actuators of the file for which the robot's own table, which is copied, has no servo: URDF has no gains.
std::string servos_toml(const RobotFile& robot, robot_formats::RobotDescription description) {
  for (robot_formats::BodyDescription& body : description.bodies) {
    for (robot_formats::JointDescription& joint : body.joints) {
      const bool has_gain = joint.servo && (joint.servo->position_gain > 0 || joint.servo->velocity_gain > 0);
      if (!has_gain || robot.table.servos.contains(joint.name)) joint.servo.reset();
    }
  }
  const std::string sections = component_files::servo_sections(description, "of_file");
  return sections.empty() ? "" : "\n" + sections;
}

/// Rectangles of the file's own frames, which URDF does not have.
std::string sole_sizes_toml(const RobotFile& robot, const robot_formats::RobotDescription& description) {
  std::string text;
  for (const robot_formats::BodyDescription& body : description.bodies) {
    for (const robot_formats::FrameDescription& frame : body.frames) {
      if (!is_sole(frame, robot.table)) continue;
      text += fmt::format("{} = [{}, {}]\n", component_files::toml_quoted(frame.name), 2 * frame.box->half_length,
                          2 * frame.box->half_width);
    }
  }
  return text.empty() ? "" : "\n[sole_sizes]  # [m] length, width\n" + text;
}

/// Data that URDF does not have.
std::string toml_beside_urdf(const RobotFile& robot, const robot_formats::RobotDescription& description,
                             bool own_table) {
  const std::string sizes = robot.table.sole_sizes.empty() ? sole_sizes_toml(robot, description) : "";
  return sizes + (own_table ? servos_toml(robot, description) : "");
}

std::string rates_for_table(const RobotFile& robot, const robot_formats::RobotDescription& description,
                            RobotConversion& result) {
  const std::string rates = rate_limits_toml(description);
  if (robot.table.rate_limits.empty() || rates.empty()) return rates;
  result.warnings.push_back(fmt::format("{}: largest rates of other joints than those of the table are left out",
                                        description.bodies[0].where));
  return "";
}

/// Removes sensors that the MJCF file has for other programs.
std::string removed_sensors_toml(const std::vector<std::string>& names) {
  std::string text =
      names.empty() ? "" : "\n[sensors]  # in the file for other programs; here they are one sensor, below\n";
  for (const std::string& name : names) text += fmt::format("{} = false\n", component_files::toml_quoted(name));
  return text;
}

/// The table [sensors] itself, besides those of single sensors: a second one would be an error.
bool has_sensor_list(const std::string& toml) {
  return toml.starts_with("[sensors]") || toml.find("\n[sensors]") != std::string::npos;
}

/// The robot's own table; empty without one.
std::string own_toml(fs::path file, RobotConversion& result) {
  file.replace_extension(".toml");
  std::error_code none;
  result.own_table = fs::exists(file, none);
  return result.own_table ? files::read_input_file(file, files::most_toml_bytes) : "";
}

/// Motions and other files named by the robot's own table.
void name_table_files(const fs::path& file, const RobotFile& robot, bool lenient, RobotConversion& result) {
  TableFiles named = table_files(file, robot, lenient);
  result.files = std::move(named.beside);
  for (const fs::path& one : named.elsewhere) {
    result.left_out.push_back(
        fmt::format("{}: the TOML file names it, but it is in no folder of the robot: not copied", one.string()));
  }
}

/// MuJoCo refuses a file with an inertia that no solid body has, unless it may replace it (mjcf_writer.h).
void name_evened_inertias(const robot_formats::RobotDescription& description, RobotConversion& result) {
  for (const robot_formats::BodyDescription& body : description.bodies) {
    const Vec3d moments = robot_formats::principal_moments(body.solid.inertia);
    if (!(body.solid.mass > 0) || !robot_formats::breaks_triangle_inequality(moments)) continue;
    result.left_out.push_back(
        fmt::format("{}: inertia of body '{}', which no solid body has: its mean moment {:.3g} kg m^2 is read",
                    body.solid_where.empty() ? body.where : body.solid_where, body.name,
                    (moments.x + moments.y + moments.z) / 3));
  }
}

/// Returns the additions to the TOML file.
std::string write_mjcf(robot_formats::RobotDescription& description, RobotFile& robot, bool with_sensors,
                       const ConversionOptions& options, RobotConversion& result) {
  if (!result.own_table) give_soles(description, robot);
  exclude_overlaps(description);
  give_key(description);
  std::vector<std::string> doubles;
  if (with_sensors) doubles = give_mjcf_sensors(description, robot.description);
  name_evened_inertias(description, result);
  result.text = robot_formats::mjcf::to_mjcf(description, {options.folder});
  return rates_for_table(robot, description, result) + removed_sensors_toml(doubles);
}

std::string write_urdf(const robot_formats::RobotDescription& description, const RobotFile& robot,
                       const ConversionOptions& options, RobotConversion& result) {
  robot_formats::urdf::UrdfText urdf = robot_formats::urdf::to_urdf(description, {options.folder, options.mesh_folder});
  result.text = std::move(urdf.text);
  result.meshes = std::move(urdf.meshes);
  result.left_out = std::move(urdf.left_out);
  return toml_beside_urdf(robot, description, result.own_table);
}

/// What has no effect here is not written either: one line.
void name_unused(const fs::path& file, const std::vector<robot_formats::Unused>& unused, RobotConversion& result) {
  if (unused.empty()) return;
  std::vector<std::string> words;
  for (const robot_formats::Unused& each : unused) words.push_back(each.word);
  result.left_out.push_back(fmt::format("{}: without effect here: {}", file.string(), fmt::join(words, ", ")));
}

}  // namespace

RobotConversion convert_robot(const fs::path& file, const ConversionOptions& options) {
  RobotConversion result;
  robot_formats::ReaderOptions as_written = options.reader;
  as_written.face_forward = false;
  // The file is converted as it is: its base is not turned.
  RobotFile robot = read_robot(file, as_written);
  result.warnings = robot.warnings;
  robot_formats::RobotDescription description = read_all_bodies(file, options.reader);
  take_repaired_solids(description, robot);
  give_servos(description, robot);
  if (options.fit) result.fits = fit_meshes(description, *options.fit);
  count(description, result);
  const std::string own = own_toml(file, result);
  std::string extra;
  if (options.format == WrittenFormat::mjcf) {
    extra = write_mjcf(description, robot, !has_sensor_list(own), options, result);
  } else {
    extra = write_urdf(description, robot, options, result);
  }
  name_unused(file, description.unused, result);
  if (result.own_table) name_table_files(file, robot, options.reader.lenient, result);
  result.toml = (result.own_table ? own : roles_toml(robot.description, robot.table)) + extra;
  result.toml +=
      component_files::sensor_sections(sensors_for_table(options.format, robot, description, result.warnings));
  return result;
}

}  // namespace murosimf::robot
