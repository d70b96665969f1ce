#include "murosimf/formats/urdf/urdf_sensor.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/formats/urdf/urdf_value.h"

namespace murosimf::formats::urdf {
namespace {

/// The number of an element inside; `fallback` if there is none.
double child_number(const files::XmlElement& parent, const char* tag, double fallback = 0) {
  const auto child = only_child(parent, tag);
  return child ? text_number(*child) : fallback;
}

struct Distortion {
  const char *key, *in_lens, *in_plugin;
};
constexpr std::array distortions{Distortion{"k1", "k1", "distortionK1"}, Distortion{"k2", "k2", "distortionK2"},
                                 Distortion{"k3", "k3", "distortionK3"}, Distortion{"p1", "p1", "distortionT1"},
                                 Distortion{"p2", "p2", "distortionT2"}};

/// Also from the element `name` of each plugin of the sensor.
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

/// The format counts the center of the picture from the picture's corner, not from the middle of a pixel.
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

/// What is not said is as the format has it by default.
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
  if (std::ranges::any_of(bends, [](const auto& entry) { return entry.second != 0; })) numbers.merge(bends);
  return numbers;
}

Transformd read_pose(const files::XmlElement& sensor) {
  const auto pose = only_child(sensor, "pose");
  if (!pose || pose->text().empty()) return {};
  const auto p = needed_numbers(*pose, pose->text(), 6, "<pose>");
  return {{p[0], p[1], p[2]}, from_roll_pitch_yaw({p[3], p[4], p[5]})};
}

/// The larger error of each kind.
void widen(sensors::SignalSpec& signal, const files::XmlElement& noise, UrdfLog& log) {
  const double deviation = child_number(noise, "stddev"), bias = child_number(noise, "bias_stddev");
  if (deviation < 0 || bias < 0) noise.fail("a deviation of noise is negative; it must be at least 0");
  signal.noise = std::max(signal.noise, deviation);
  signal.bias = std::max(signal.bias, bias);
  for (const char* tag : {"mean", "bias_mean", "dynamic_bias_stddev"}) {
    if (child_number(noise, tag) != 0) log.note(noise, fmt::format("<{}> of noise is not simulated", tag));
  }
}

/// Noise of the axes x, y, z inside `quantity`.
void read_axes(const files::XmlElement& imu, const char* quantity, const char* output,
               description::SensorDescription& description, UrdfLog& log) {
  const auto inside = only_child(imu, quantity);
  if (!inside) return;
  for (const char* tag : {"x", "y", "z"}) {
    const auto axis = only_child(*inside, tag);
    if (!axis) continue;
    if (const auto noise = only_child(*axis, "noise")) widen(description.signals[output], *noise, log);
  }
}

void read_imu(const files::XmlElement& imu, description::SensorDescription& description, UrdfLog& log) {
  read_axes(imu, "angular_velocity", "gyroscope", description, log);
  read_axes(imu, "linear_acceleration", "accelerometer", description, log);
  const auto noise = only_child(imu, "noise");  // older than SDFormat 1.5
  if (!noise) return;
  if (const auto rate = only_child(*noise, "rate")) widen(description.signals["gyroscope"], *rate, log);
  if (const auto accel = only_child(*noise, "accel")) widen(description.signals["accelerometer"], *accel, log);
}

void read_scan(const files::XmlElement& scan, description::SensorDescription& description, UrdfLog& log) {
  const auto horizontal = only_child(scan, "horizontal");
  if (const auto vertical = only_child(scan, "vertical"); vertical && child_number(*vertical, "samples", 1) > 1) {
    log.note(*vertical, "a laser scans one plane only; <vertical> is not used");
  }
  if (!horizontal) return;
  const double first = child_number(*horizontal, "min_angle"), last = child_number(*horizontal, "max_angle");
  description.numbers["rays"] =
      std::round(child_number(*horizontal, "samples", 640) * child_number(*horizontal, "resolution", 1));
  description.numbers["fov"] = last - first;
  description.numbers["first_angle"] = first;
}

/// A scanner's element is called as its kind, without the GPU.
void read_laser(const files::XmlElement& laser, description::SensorDescription& description, UrdfLog& log) {
  if (const auto scan = only_child(laser, "scan")) read_scan(*scan, description, log);
  if (const auto range = only_child(laser, "range")) {
    description.numbers["range_min"] = child_number(*range, "min");
    description.numbers["range_max"] = child_number(*range, "max");
    if (const double step = child_number(*range, "resolution"); step > 0) description.signals[""].resolution = step;
  }
  if (const auto noise = only_child(laser, "noise")) widen(description.signals[""], *noise, log);
}

}  // namespace

double text_number(const files::XmlElement& element) {
  const std::string text = element.text();
  const std::string value = text.empty() ? element.attribute("value").value_or("") : text;
  return needed_numbers(element, value, 1, fmt::format("<{}>", element.tag()))[0];
}

description::SensorDescription read_sensor(const files::XmlElement& sensor, const std::string& frame, UrdfLog& log) {
  description::SensorDescription description{sensor.attribute("type").value_or(""),
                                             sensor.attribute("name").value_or(""),
                                             frame,
                                             sensor.where(),
                                             read_pose(sensor),
                                             child_number(sensor, "update_rate")};
  const auto cameras = sensor.children("camera");
  if (!cameras.empty()) description.numbers = read_camera(sensor, cameras[0]);
  if (description.rate != 0 && !(description.rate >= 1e-3 && description.rate <= 1e6)) {
    sensor.fail(fmt::format("update_rate of the sensor is {}; write 0 or from 0.001 to 1000000 Hz", description.rate));
  }
  if (const auto imu = only_child(sensor, "imu")) read_imu(*imu, description, log);
  for (const char* tag : {"ray", "lidar"}) {
    if (const auto laser = only_child(sensor, tag)) read_laser(*laser, description, log);
  }
  return description;
}

}  // namespace murosimf::formats::urdf
