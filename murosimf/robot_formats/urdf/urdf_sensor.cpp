#include "murosimf/robot_formats/urdf/urdf_sensor.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/math/roll_pitch_yaw.h"
#include "murosimf/model/error.h"
#include "murosimf/robot_formats/urdf/gazebo_schema.h"
#include "murosimf/robot_formats/urdf/urdf_noise.h"
#include "murosimf/robot_formats/urdf/urdf_value.h"

namespace murosimf::robot_formats::urdf {
namespace {

/// The number of an element inside; `fallback` if there is none.
double child_number(const files::XmlElement& parent, const char* tag, double fallback = 0) {
  const auto child = only_child(parent, tag);
  return child ? text_number(*child) : fallback;
}

/// The text of an element inside; empty if there is none.
std::string child_text(const files::XmlElement& parent, const char* tag) {
  const auto child = only_child(parent, tag);
  return child ? child->text() : "";
}

struct Distortion {
  const char *key, *in_lens, *in_plugin;
};
constexpr std::array distortions{Distortion{"k1", "k1", "distortionK1"}, Distortion{"k2", "k2", "distortionK2"},
                                 Distortion{"k3", "k3", "distortionK3"}, Distortion{"p1", "p1", "distortionT1"},
                                 Distortion{"p2", "p2", "distortionT2"}};

/// A coefficient of the lens, also from the element `in_plugin` of each plugin of the sensor.
double distortion(const files::XmlElement& sensor, const std::optional<files::XmlElement>& lens, const char* in_lens,
                  const char* in_plugin) {
  if (lens && only_child(*lens, in_lens)) return child_number(*lens, in_lens);
  for (const files::XmlElement& plugin : sensor.children("plugin")) {
    if (only_child(plugin, in_plugin)) return child_number(plugin, in_plugin);
  }
  return 0;
}

double pixels(const files::XmlElement& image, const char* tag, double usual) {
  const double number = child_number(image, tag, usual);
  if (number >= 1 && number <= 1e5 && number == std::floor(number)) return number;
  image.fail(fmt::format("{} of the image is {}; write whole pixels, 1 to 100000", tag, number));
}

/// Reads a lens. The format counts the center of the picture from the picture's corner, not from the middle of a pixel.
void read_lens(const files::XmlElement& intrinsics, std::map<std::string, double>& numbers) {
  numbers["fx"] = child_number(intrinsics, "fx", 277);
  numbers["fy"] = child_number(intrinsics, "fy", 277);
  numbers["cx"] = child_number(intrinsics, "cx", 160) - 0.5;
  numbers["cy"] = child_number(intrinsics, "cy", 120) - 0.5;
  if (const double skew = child_number(intrinsics, "s", 0); skew != 0) numbers["skew"] = skew;
  if (!(numbers["fx"] > 0 && numbers["fy"] > 0)) intrinsics.fail("fx and fy of a lens must be positive");
}

void read_fov(const files::XmlElement& camera, std::map<std::string, double>& numbers) {
  const double fov = child_number(camera, "horizontal_fov", 1.047);
  if (!(fov > 0 && fov < 2 * pi)) {
    camera.fail(fmt::format("horizontal_fov of the camera is {}; write radians, above 0 and below 6.28", fov));
  }
  numbers["fov"] = fov;
}

/// Reads a camera; missing numbers have the defaults of the format.
std::map<std::string, double> read_camera(const files::XmlElement& sensor, const files::XmlElement& camera) {
  std::map<std::string, double> numbers{{"width", 320}, {"height", 240}};
  if (const auto image = only_child(camera, "image")) {
    for (auto& [side, size] : numbers) size = pixels(*image, side.c_str(), size);
  }
  const auto lens = only_child(camera, "lens");
  const auto intrinsics = lens ? only_child(*lens, "intrinsics") : std::nullopt;
  if (intrinsics) {
    read_lens(*intrinsics, numbers);
  } else {
    read_fov(camera, numbers);
  }
  const auto bend = only_child(camera, "distortion");
  std::map<std::string, double> bends;
  for (const auto& [key, in_lens, in_plugin] : distortions) bends[key] = distortion(sensor, bend, in_lens, in_plugin);
  // Without coefficients the camera has no distortion at all, instead of five zeros.
  if (std::ranges::any_of(bends, [](const auto& entry) { return entry.second != 0; })) numbers.merge(bends);
  return numbers;
}

Transformd read_pose(const files::XmlElement& sensor) {
  const auto pose = only_child(sensor, "pose");
  if (!pose || pose->text().empty()) return {};
  const auto p = needed_numbers(*pose, pose->text(), 6, "<pose>");
  return {{p[0], p[1], p[2]}, from_roll_pitch_yaw({p[3], p[4], p[5]})};
}

void read_imu(const files::XmlElement& imu, robot_formats::SensorDescription& description, UrdfLog& log) {
  read_axes(imu, "angular_velocity", "gyroscope", description, log);
  read_axes(imu, "linear_acceleration", "accelerometer", description, log);
  const auto noise = only_child(imu, "noise");  // of files older than SDFormat 1.5
  if (!noise) return;
  const auto type = noise->attribute("type").value_or(child_text(*noise, "type"));
  if (type == "none") return;
  if (const auto rate = only_child(*noise, "rate")) description.signals["gyroscope"] = read_noise(*rate, log);
  if (const auto accel = only_child(*noise, "accel")) description.signals["accelerometer"] = read_noise(*accel, log);
}

void read_scan(const files::XmlElement& scan, robot_formats::SensorDescription& description, UrdfLog& log) {
  const auto horizontal = only_child(scan, "horizontal");
  if (const auto vertical = only_child(scan, "vertical"); vertical && child_number(*vertical, "samples", 1) > 1) {
    log.unused(*vertical, "scan/vertical", "a laser scans one plane only; <vertical> is not used");
  }
  if (!horizontal) return;
  const double first = child_number(*horizontal, "min_angle"), last = child_number(*horizontal, "max_angle");
  // Samples times resolution: the format interpolates rays between the simulated ones.
  description.numbers["rays"] =
      std::round(child_number(*horizontal, "samples", 640) * child_number(*horizontal, "resolution", 1));
  description.numbers["fov"] = last - first;
  description.numbers["first_angle"] = first;
}

/// Reads a scanner, of which the element has the name of the kind, without the GPU.
void read_laser(const files::XmlElement& laser, robot_formats::SensorDescription& description, UrdfLog& log) {
  double step = 0;  // [m]
  if (const auto scan = only_child(laser, "scan")) read_scan(*scan, description, log);
  if (const auto range = only_child(laser, "range")) {
    description.numbers["range_min"] = child_number(*range, "min");
    description.numbers["range_max"] = child_number(*range, "max");
    step = child_number(*range, "resolution");
  }
  const auto noise = only_child(laser, "noise");
  if (noise) description.signals[""] = read_noise(*noise, log);
  if (step > 0) description.signals[""].resolution = step;
}

/// Reads the noise of every pixel; a mean would be a brighter picture.
void read_pixel_noise(const files::XmlElement& camera, robot_formats::SensorDescription& description, UrdfLog& log) {
  const auto element = only_child(camera, "noise");
  if (!element) return;
  const sensors::SignalSpec noise = read_noise(*element, log);
  if (noise.noise > 0) description.numbers["read_noise"] = noise.noise;
  sensors::SignalSpec rest = noise;
  rest.noise = 0;
  if (rest != sensors::SignalSpec{}) {
    log.unused(*element, "camera/noise", "of the noise of a camera only stddev is used");
  }
}

/// Reads axes and direction of a sensor at a joint.
void read_force_torque(const files::XmlElement& sensor, const SensorPlace& at,
                       robot_formats::SensorDescription& description, UrdfLog& log) {
  const auto element = only_child(sensor, "force_torque");
  const std::string frame = element ? child_text(*element, "frame") : "";
  const std::string direction = element ? child_text(*element, "measure_direction") : "";
  // The child's axes are the default of the format.
  if (frame.empty() || frame == "child") {
    description.texts["axes"] = at.child;
  } else if (frame == "parent") {
    description.texts["axes"] = at.parent;
  } else if (frame != "sensor") {
    element->fail(unknown_name("frame of a force_torque sensor", frame, {"child", "parent", "sensor"}));
  }
  if (direction == "parent_to_child") {
    description.texts["direction"] = direction;
  } else if (!direction.empty() && direction != "child_to_parent") {
    element->fail(unknown_name("measure_direction", direction, {"child_to_parent", "parent_to_child"}));
  }
  if (!element) return;
  for (const char* quantity : {"force", "torque"}) read_axes(*element, quantity, quantity, description, log);
}

void name_plugins(const files::XmlElement& sensor, UrdfLog& log) {
  for (const files::XmlElement& plugin : sensor.children("plugin")) {
    log.unused(plugin, "sensor/plugin", "plugins of sensors are not used, but for the distortion of cameras");
  }
}

}  // namespace

double text_number(const files::XmlElement& element) {
  const std::string text = element.text();
  const std::string value = text.empty() ? element.attribute("value").value_or("") : text;
  return needed_numbers(element, value, 1, fmt::format("<{}>", element.tag()))[0];
}

robot_formats::SensorDescription read_sensor(const files::XmlElement& sensor, const SensorPlace& at, UrdfLog& log) {
  // A given place means SDF: its reader has checked all words with its own schema.
  if (!at.place) log.take(files::validate(sensor, gazebo_schema()));
  name_plugins(sensor, log);
  robot_formats::SensorDescription description{
      sensor.attribute("type").value_or(""),    sensor.attribute("name").value_or(""), at.frame, sensor.where(),
      at.place ? *at.place : read_pose(sensor), child_number(sensor, "update_rate")};
  const auto cameras = sensor.children("camera");
  if (!cameras.empty()) {
    description.numbers = read_camera(sensor, cameras[0]);
    description.place = description.place * read_pose(cameras[0]);
    read_pixel_noise(cameras[0], description, log);
  }
  if (description.kind == "force_torque") read_force_torque(sensor, at, description, log);
  if (description.rate != 0 && !(description.rate >= 1e-3 && description.rate <= 1e6)) {
    sensor.fail(fmt::format("update_rate of the sensor is {}; write 0 or from 0.001 to 1000000 Hz", description.rate));
  }
  if (const auto imu = only_child(sensor, "imu")) read_imu(*imu, description, log);
  for (const char* tag : {"ray", "lidar"}) {
    if (const auto laser = only_child(sensor, tag)) read_laser(*laser, description, log);
  }
  return description;
}

}  // namespace murosimf::robot_formats::urdf
