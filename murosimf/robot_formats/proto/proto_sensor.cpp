#include "murosimf/robot_formats/proto/proto_sensor.h"

#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

namespace murosimf::robot_formats::proto {
namespace {

struct Device {
  std::string_view type;
  const char *kind, *object_kind;  ///< SensorDescription
};

constexpr std::array devices{Device{"Gyro", "gyro", "body"},
                             Device{"Accelerometer", "accelerometer", "body"},
                             Device{"InertialUnit", "framequat", "body"},
                             Device{"GPS", "framepos", "body"},
                             Device{"Camera", "camera", "body"},
                             Device{"TouchSensor", "touch", "body"},
                             Device{"DistanceSensor", "rangefinder", "body"}};

double pixels(const Node& camera, const char* field) {
  const double number = camera.number(field, 64);
  if (number >= 1 && number <= 1e5 && number == std::floor(number)) return number;
  camera.fail(fmt::format("{} of Camera is {}; write whole pixels, 1 to 100000", field, number), camera.find(field));
}

void read_camera(const Node& camera, bool old, robot_formats::SensorDescription& sensor) {
  const double fov = camera.number("fieldOfView", 0.7854);
  if (!(fov > 0 && fov < 2 * pi)) {
    camera.fail(fmt::format("fieldOfView of Camera is {}; write radians, above 0 and below 6.28", fov),
                camera.find("fieldOfView"));
  }
  sensor.numbers = {{"width", pixels(camera, "width")}, {"height", pixels(camera, "height")}, {"fov", fov}};
  if (const double noise = camera.at_least_zero("noise", 0); noise > 0) sensor.numbers["read_noise"] = noise;
  // Cameras here look along x with z up, old ones along -z with y up.
  if (old) sensor.place.orientation = {{0, 0, -1}, {-1, 0, 0}, {0, 1, 0}};
}

}  // namespace

std::optional<robot_formats::SensorDescription> read_sensor(const Node& device, const std::string& body, bool old,
                                                            ProtoLog& log) {
  for (const Device& known : devices) {
    if (known.type != device.type) continue;
    robot_formats::SensorDescription sensor{known.kind, device.text("name", ""), body, device.where};
    sensor.object_kind = known.object_kind;
    if (device.type == "Camera") read_camera(device, old, sensor);
    // The ray of a DistanceSensor goes along x, that of a rangefinder along z.
    if (device.type == "DistanceSensor") sensor.place.orientation = rotation_y(0.5 * pi);
    if (const Field* table = device.find("lookupTable"); table && !table->empty()) {
      log.unused(table->where, "lookupTable", "lookup tables are not used: sensors show SI units without noise");
    }
    return sensor;
  }
  return std::nullopt;
}

robot_formats::SensorDescription read_position_sensor(const Node& sensor, const std::string& joint) {
  robot_formats::SensorDescription description{"jointpos", sensor.text("name", joint + "_sensor"), joint, sensor.where};
  description.object_kind = "joint";
  return description;
}

}  // namespace murosimf::robot_formats::proto
