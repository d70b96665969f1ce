#include "murosimf/robot_formats/mjcf/mjcf_camera.h"

#include <cmath>

#include <fmt/format.h>

#include "murosimf/math/assert.h"

namespace murosimf::robot_formats::mjcf {
namespace {

constexpr double usual_width = 640, usual_height = 480;  // [px]
constexpr double usual_fov = 45;                         // [deg] vertical, default of the format
constexpr double most_pixels = 1e5;                      // along a side
constexpr double pixel_pitch = 1e-6;                     // [m] of written sensors: only ratios matter

/// Two positive numbers; nothing if the attribute is missing, or zero as by default.
std::optional<Vec3d> pair_of(const MjcfAttributes& attributes, const char* name) {
  const auto numbers = attributes.numbers(name, 2, 2);
  if (numbers.empty() || (numbers[0] == 0 && numbers[1] == 0)) return std::nullopt;
  if (!(numbers[0] > 0 && numbers[1] > 0)) {
    attributes.source(name).fail(fmt::format("{} '{}' of camera must be positive", name, attributes.text(name)));
  }
  return Vec3d{numbers[0], numbers[1], 0};
}

void read_size(const MjcfAttributes& attributes, std::map<std::string, double>& numbers) {
  const auto size = pair_of(attributes, "resolution");
  const bool said = size && !(size->x == 1 && size->y == 1);  // 1 x 1 is the default of the format
  numbers["width"] = said ? size->x : usual_width;
  numbers["height"] = said ? size->y : usual_height;
  // A fraction of a pixel, or more than memory holds, is an error of the file.
  for (const char* side : {"width", "height"}) {
    const double pixels = numbers[side];
    if (pixels <= most_pixels && pixels == std::floor(pixels)) continue;
    attributes.source("resolution")
        .fail(fmt::format("resolution '{}' of camera must be whole numbers up to {}", attributes.text("resolution"),
                          most_pixels));
  }
}

/// [px] `name` in lengths of the sensor, or `name`pixel, which precedes it.
Vec3d in_pixels(const MjcfAttributes& attributes, const std::string& name, const Vec3d& per_length) {
  const auto pixels = attributes.numbers(name + "pixel", 2, 2), lengths = attributes.numbers(name, 2, 2);
  if (!pixels.empty() && (pixels[0] != 0 || pixels[1] != 0)) return {pixels[0], pixels[1], 0};
  if (lengths.empty()) return {};
  return {lengths[0] * per_length.x, lengths[1] * per_length.y, 0};
}

void read_sensor(const MjcfAttributes& attributes, const Vec3d& size, std::map<std::string, double>& numbers) {
  const double width = numbers["width"], height = numbers["height"];
  MUROSIMF_ASSERT(size.x > 0 && size.y > 0);
  const Vec3d per_length{width / size.x, height / size.y, 0};
  const Vec3d focal = in_pixels(attributes, "focal", per_length);
  const Vec3d principal = in_pixels(attributes, "principal", per_length);
  if (!(focal.x > 0 && focal.y > 0)) {
    attributes.source("sensorsize").fail("camera with sensorsize needs a positive focal length; add focal");
  }
  numbers["fx"] = focal.x;
  numbers["fy"] = focal.y;
  // Half a pixel less: coordinates count from the center of the first pixel; and the other way, as MuJoCo shifts the picture.
  numbers["cx"] = 0.5 * (width - 1) - principal.x;
  numbers["cy"] = 0.5 * (height - 1) - principal.y;
}

void read_fov(const MjcfAttributes& attributes, std::map<std::string, double>& numbers) {
  for (const char* name : {"focal", "focalpixel", "principal", "principalpixel"}) {
    if (attributes.has(name)) attributes.source(name).fail(fmt::format("{} of camera needs sensorsize; add it", name));
  }
  const double degrees = attributes.number("fovy", usual_fov);
  if (!(degrees > 0 && degrees < 180)) {
    attributes.source("fovy").fail(fmt::format("fovy {} of camera must be from 0 to 180 degrees", degrees));
  }
  // fovy is vertical, the sensor's fov horizontal: their tangents are in the ratio of the sides.
  const double half = 0.5 * degrees * pi / 180;
  numbers["fov"] = 2 * std::atan(std::tan(half) * numbers["width"] / numbers["height"]);
}

std::string obstacle_of(const MjcfAttributes& attributes) {
  const auto mode = attributes.choice("mode", {"fixed", "track", "trackcom", "targetbody", "targetbodycom"});
  if (mode != "fixed") return fmt::format("its mode is {}, so it is not fixed to the robot", mode);
  const bool flat = attributes.text("projection") == "orthographic" || attributes.text("orthographic") == "true";
  return flat ? "it has no perspective" : "";
}

}  // namespace

robot_formats::SensorDescription read_mjcf_camera(const MjcfAttributes& attributes, const std::string& frame) {
  robot_formats::SensorDescription camera{"camera", attributes.text("name"), frame, attributes.element().where()};
  camera.object_kind = "camera";
  camera.place.orientation = camera_axes;
  camera.obstacle = obstacle_of(attributes);
  if (!camera.obstacle.empty()) return camera;
  read_size(attributes, camera.numbers);
  if (const auto size = pair_of(attributes, "sensorsize")) {
    read_sensor(attributes, *size, camera.numbers);
  } else {
    read_fov(attributes, camera.numbers);
  }
  return camera;
}

bool is_mjcf_camera(const robot_formats::SensorDescription& sensor) {
  return sensor.kind == "camera" && sensor.object_kind == "camera" && sensor.obstacle.empty();
}

void write_mjcf_camera(files::XmlText& xml, const robot_formats::SensorDescription& camera) {
  const auto& numbers = camera.numbers;
  MUROSIMF_ASSERT(numbers.contains("width") && numbers.contains("height"));
  const double width = numbers.at("width"), height = numbers.at("height");
  xml.numbers("resolution", {width, height});
  if (const auto fov = numbers.find("fov"); fov != numbers.end()) {
    xml.numbers("fovy", {2 * std::atan(std::tan(0.5 * fov->second) * height / width) * 180 / pi});
    return;
  }
  xml.numbers("sensorsize", {pixel_pitch * width, pixel_pitch * height});
  xml.numbers("focal", {pixel_pitch * numbers.at("fx"), pixel_pitch * numbers.at("fy")});
  xml.numbers("principal", {pixel_pitch * (0.5 * (width - 1) - numbers.at("cx")),
                            pixel_pitch * (0.5 * (height - 1) - numbers.at("cy"))});
}

}  // namespace murosimf::robot_formats::mjcf
