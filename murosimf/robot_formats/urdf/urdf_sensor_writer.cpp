#include "murosimf/robot_formats/urdf/urdf_sensor_writer.h"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/math/roll_pitch_yaw.h"
#include "murosimf/robot_formats/urdf/urdf_place_writer.h"
#include "murosimf/robot_formats/urdf/urdf_writer.h"

namespace murosimf::robot_formats::urdf {
namespace {

constexpr std::array<std::string_view, 7> camera_numbers{"width", "height", "fov", "fx", "fy", "cx", "cy"};

void write_number(files::XmlText& xml, const char* tag, double value) {
  xml.begin(tag).content(fmt::format("{}", value)).end();
}

void write_pose(files::XmlText& xml, const Transformd& place) {
  const Vec3d p = place.position, turn = roll_pitch_yaw(place.orientation);
  xml.begin("pose");
  xml.content(fmt::format("{} {} {} {} {} {}", p.x, p.y, p.z, turn.x, turn.y, turn.z)).end();
}

/// Writes a lens. The format counts the center of the picture from the picture's corner, not from the middle of a pixel.
void write_lens(files::XmlText& xml, const std::map<std::string, double>& numbers) {
  xml.begin("lens").begin("intrinsics");
  MUROSIMF_ASSERT(numbers.contains("fx") && numbers.contains("cx"));
  for (const char* key : {"fx", "fy"}) write_number(xml, key, numbers.at(key));
  for (const char* key : {"cx", "cy"}) write_number(xml, key, numbers.at(key) + 0.5);
  xml.end().end();
}

void write_camera(files::XmlText& xml, const std::map<std::string, double>& numbers) {
  xml.begin("camera");
  if (numbers.contains("fov")) write_number(xml, "horizontal_fov", numbers.at("fov"));
  xml.begin("image");
  for (const char* key : {"width", "height"}) write_number(xml, key, numbers.at(key));
  xml.end();
  if (numbers.contains("fx")) write_lens(xml, numbers);
  xml.end();
}

bool has_only_camera_numbers(const std::map<std::string, double>& numbers) {
  const auto known = [](const auto& entry) {
    return std::ranges::find(camera_numbers, entry.first) != camera_numbers.end();
  };
  const bool lens =
      numbers.contains("fx") && numbers.contains("fy") && numbers.contains("cx") && numbers.contains("cy");
  return std::ranges::all_of(numbers, known) && numbers.contains("width") && numbers.contains("height") &&
         (lens || numbers.contains("fov"));
}

}  // namespace

bool is_urdf_sensor(const robot_formats::SensorDescription& sensor) {
  if (!sensor.obstacle.empty() || !sensor.signals.empty() || !sensor.texts.empty()) return false;
  if (sensor.kind == "imu") return sensor.numbers.empty();
  return sensor.kind == "camera" && has_only_camera_numbers(sensor.numbers);
}

void write_sensor(files::XmlText& xml, const robot_formats::SensorDescription& sensor, const std::string& link,
                  const Transformd& place) {
  MUROSIMF_ASSERT(is_urdf_sensor(sensor));
  xml.begin("gazebo").text("reference", link);
  xml.begin("sensor").text("name", sensor.name.empty() ? sensor.kind : sensor.name).text("type", sensor.kind);
  if (sensor.rate > 0) write_number(xml, "update_rate", sensor.rate);
  write_pose(xml, place);
  if (sensor.kind == "camera") write_camera(xml, sensor.numbers);
  xml.end().end();
}

}  // namespace murosimf::robot_formats::urdf
