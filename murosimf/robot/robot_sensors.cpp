#include "murosimf/robot/robot_sensors.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/files/xml_element.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::robot {
namespace {

using sensors::SensorSpec;

struct SensorKind {
  std::string_view kind, type;
  std::string_view difference;  ///< between the sensor of the file and the simulated one; may be empty
};

constexpr double usual_camera_rate = 25;  // [Hz] if the file has none: steps of 1, 2, 4, 5, 8 ms divide its period

constexpr std::string_view whole_link = "it shows the contact forces of the whole link";

constexpr std::array kinds{SensorKind{"accelerometer", "accelerometer", ""},
                           SensorKind{"actuatorfrc", "joint_torque", ""},
                           SensorKind{"camera", "camera", ""},
                           SensorKind{"contact", "contact_force", ""},
                           SensorKind{"force", "joint_wrench", ""},
                           SensorKind{"force_torque", "joint_wrench", ""},
                           SensorKind{"frameangvel", "angular_velocity", ""},
                           SensorKind{"framelinvel", "linear_velocity", ""},
                           SensorKind{"framepos", "position", ""},
                           SensorKind{"framequat", "orientation", ""},
                           SensorKind{"gpu_lidar", "laser", ""},
                           SensorKind{"gpu_ray", "laser", ""},
                           SensorKind{"gyro", "gyroscope", ""},
                           SensorKind{"imu", "imu", ""},
                           SensorKind{"jointactuatorfrc", "joint_torque", ""},
                           SensorKind{"jointpos", "joint_position", ""},
                           SensorKind{"jointvel", "joint_velocity", ""},
                           SensorKind{"lidar", "laser", ""},
                           SensorKind{"rangefinder", "rangefinder", "nothing found is infinity, not -1"},
                           SensorKind{"ray", "laser", ""},
                           SensorKind{"subtreecom", "center_of_mass", ""},
                           SensorKind{"torque", "joint_wrench", ""},
                           SensorKind{"touch", "contact_force", whole_link},
                           SensorKind{"velocimeter", "velocimeter", ""}};

/// Null: unknown.
const SensorKind* find_kind(std::string_view name) {
  MUROSIMF_ASSERT(std::ranges::is_sorted(kinds, {}, &SensorKind::kind));
  const auto found = std::ranges::find(kinds, name, &SensorKind::kind);
  return found == kinds.end() ? nullptr : &*found;
}

/// A name that is valid in a path, and that no other sensor has.
std::string free_name(const robot_formats::SensorDescription& sensor, const std::string& type,
                      const std::vector<SensorSpec>& others) {
  std::string name = sensor.name.empty() ? type : sensor.name;
  std::ranges::replace_if(
      name,
      [](char c) {
        return !component_files::is_sensor_name({&c, 1});
      },
      '_');
  const auto taken = [&](const std::string& free) {
    return std::ranges::find(others, free, &SensorSpec::name) != others.end();
  };
  std::string free = name;
  for (int number = 2; taken(free); ++number) free = fmt::format("{}_{}", name, number);
  return free;
}

/// The object of the model that is made from a site, body or joint of the file (robot_builder.h).
std::string object_of(const robot_formats::SensorDescription& sensor, const Model& model) {
  if (sensor.object_kind.empty()) return sensor.frame;
  const std::string suffix = sensor.object_kind == "xbody" ? "body" : sensor.object_kind;
  const std::string renamed = sensor.frame + "." + suffix;
  return model.find_object(renamed) ? renamed : sensor.frame;
}

/// The reason that it cannot be simulated; empty: it can.
std::string why_not(const robot_formats::SensorDescription& sensor, const SensorKind* kind,
                    const robot_formats::RobotDescription& description) {
  if (!kind) return "not simulated";
  if (!sensor.obstacle.empty()) return "not simulated: " + sensor.obstacle;
  const bool of_base = sensor.frame == description.bodies[0].name;
  if (sensor.kind == "subtreecom" && !of_base) return "not simulated: only the center of mass of the whole robot is";
  return {};
}

std::string line_of(const robot_formats::SensorDescription& sensor, std::string_view text) {
  return files::one_line(
      fmt::format("{}: sensor {} '{}' at '{}': {}", sensor.where, sensor.kind, sensor.name, sensor.frame, text));
}

void note(robot_formats::RobotDescription& description, const robot_formats::SensorDescription& sensor,
          std::string_view text) {
  if (!text.empty()) description.notes.push_back(line_of(sensor, text));
}

/// [Hz] The highest rate up to `rate` with a period of a whole number of milliseconds, the usual steps: published cameras
/// have 30 Hz.
double rate_of_steps(double rate) {
  MUROSIMF_ASSERT(rate > 0);
  constexpr double rounding = 1e-9;  // [1]
  return 1e3 / std::ceil(1e3 / rate * (1 - rounding));
}

/// The rate of a camera, with a note if it is not the file's.
double camera_rate(robot_formats::RobotDescription& description, const robot_formats::SensorDescription& camera) {
  const double rate = rate_of_steps(camera.rate > 0 ? camera.rate : usual_camera_rate);
  if (camera.rate == 0) {
    note(description, camera, fmt::format("assumed: {:.4g} pictures per second", rate));
  } else if (rate < camera.rate * (1 - 1e-6)) {
    note(description, camera,
         fmt::format("{:.4g} pictures per second, not {:.4g}: steps are 1 ms long", rate, camera.rate));
  }
  return rate;
}

/// The object of the model with the axes of a body of the file.
std::string object_of_body(const std::string& body, const Model& model) {
  return model.find_object(body + ".body") ? body + ".body" : body;
}

/// A cut at a body with joints is behind the last of them, which has its mass; those before it have none.
void name_objects(SensorSpec& spec, const robot_formats::SensorDescription& sensor, const Model& model) {
  spec.texts["behind"] = object_of_body(sensor.behind, model);
  if (const auto axes = spec.texts.find("axes"); axes != spec.texts.end()) {
    axes->second = object_of_body(axes->second, model);
  }
}

SensorSpec spec_of(const robot_formats::SensorDescription& sensor, const std::string& type, const Model& model) {
  SensorSpec spec;
  spec.type = type;
  spec.where = sensor.where;
  spec.rate = sensor.rate;
  spec.numbers = sensor.numbers;
  spec.signals = sensor.signals;
  spec.texts = sensor.texts;
  if (type == "joint_wrench") name_objects(spec, sensor, model);
  if (sensor.object_kind == "joint" && type.starts_with("joint_")) {
    spec.objects = {sensor.frame};
    return spec;
  }
  spec.frame = object_of(sensor, model);
  spec.position = sensor.place.position;
  spec.orientation = sensor.place.orientation;
  return spec;
}

void check_frame(const SensorSpec& spec, const Model& model) {
  if (spec.frame.empty() || model.find_object(spec.frame)) return;
  const auto names = model.object_names();
  throw SetupError(files::one_line(fmt::format("{}: sensor '{}': {}", spec.where, spec.name,
                                               unknown_name("frame", spec.frame, {names.begin(), names.end()}))));
}

/// Whether its frame is in the model; otherwise an error, or a warning if `lenient`.
bool has_place(const SensorSpec& spec, const Model& model, bool lenient, robot_formats::RobotDescription& description) {
  try {
    check_frame(spec, model);
  } catch (const SetupError& error) {
    if (!lenient) throw;
    description.warnings.emplace_back(error.what());
    return false;
  }
  return true;
}

std::vector<SensorSpec> sensors_of_file(robot_formats::RobotDescription& description, const Model& model,
                                        bool lenient) {
  std::vector<SensorSpec> specs;
  for (robot_formats::SensorDescription& sensor : description.sensors) {
    const SensorKind* kind = find_kind(sensor.kind);
    const std::string reason = why_not(sensor, kind, description);
    if (!reason.empty()) {
      description.unused.push_back({files::one_line("sensor " + sensor.kind), line_of(sensor, reason)});
      continue;
    }
    note(description, sensor, kind->difference);
    SensorSpec spec = spec_of(sensor, std::string(kind->type), model);
    MUROSIMF_ASSERT(kind != nullptr);
    if (spec.type == "camera") spec.rate = camera_rate(description, sensor);
    spec.name = free_name(sensor, spec.type, specs);
    if (!has_place(spec, model, lenient, description)) continue;
    sensor.becomes = spec.name;
    specs.push_back(std::move(spec));
  }
  return specs;
}

}  // namespace

std::vector<SensorSpec> sensors_of(robot_formats::RobotDescription& description, const RobotConfig& table,
                                   const Model& model, const std::filesystem::path& folder, bool lenient) {
  std::vector<SensorSpec> specs = sensors_of_file(description, model, lenient);
  component_files::change_sensors(specs, table.sensors, folder);
  for (const SensorSpec& spec : specs) check_frame(spec, model);
  return specs;
}

}  // namespace murosimf::robot
