#include "murosimf/robot/conversion_sensors.h"

#include <algorithm>

#include "murosimf/robot_formats/mjcf/mjcf_camera.h"

namespace murosimf::robot {
namespace {

/// The body that has the frame of a link or joint of URDF; null: none.
robot_formats::BodyDescription* body_of(robot_formats::RobotDescription& description, const std::string& frame) {
  for (robot_formats::BodyDescription& body : description.bodies) {
    const bool of_joint = std::ranges::any_of(body.joints, [&](const robot_formats::JointDescription& joint) {
      return joint.name == frame;
    });
    if (body.name == frame || of_joint) return &body;
  }
  return nullptr;
}

bool is_taken(const robot_formats::RobotDescription& description, const std::string& name) {
  return std::ranges::any_of(description.bodies, [&](const robot_formats::BodyDescription& body) {
    const auto has = [&](const auto& parts) {
      return std::ranges::any_of(parts, [&](const auto& part) { return part.name == name; });
    };
    return body.name == name || has(body.joints) || has(body.frames);
  });
}

void add_imu(robot_formats::RobotDescription& description, robot_formats::BodyDescription& body,
             const robot_formats::SensorDescription& imu, const std::string& name, std::vector<std::string>& doubles) {
  const std::string site = name + "_site";
  if (is_taken(description, site)) return;
  // A site of that name in the file may be a frame for something else.
  body.frames.push_back({site, imu.where, "site", imu.place, {}});
  for (const char* kind : {"gyro", "accelerometer", "framequat"}) {
    doubles.push_back(name + "_" + kind);
    robot_formats::SensorDescription part{kind, doubles.back(), site, imu.where};
    part.object_kind = "site";
    description.sensors.push_back(std::move(part));
  }
}

void add_camera(robot_formats::RobotDescription& description, robot_formats::BodyDescription& body,
                const robot_formats::SensorDescription& camera, const std::string& name,
                std::vector<std::string>& doubles) {
  const bool taken = is_taken(description, name);
  const std::string frame = taken ? name + "_camera" : name;
  if (taken) {
    if (is_taken(description, frame)) return;
    doubles.push_back(frame);
  }
  // A camera of MJCF looks along -z.
  const Transformd of_sensor{{}, robot_formats::mjcf::camera_axes};
  const Transformd at{camera.place.position, camera.place.orientation * transpose(robot_formats::mjcf::camera_axes)};
  body.frames.push_back({frame, camera.where, "camera", at, {}});
  robot_formats::SensorDescription again{"camera", frame, frame, camera.where, of_sensor};
  again.object_kind = "camera";
  again.numbers = camera.numbers;
  description.sensors.push_back(std::move(again));
}

}  // namespace

std::vector<std::string> give_mjcf_sensors(robot_formats::RobotDescription& description,
                                           const robot_formats::RobotDescription& whole) {
  std::vector<std::string> doubles;
  const std::size_t count = std::min(description.sensors.size(), whole.sensors.size());
  // The same sensors in the same order, as far as both have them.
  for (std::size_t i = 0; i < count; ++i) {
    const robot_formats::SensorDescription sensor = description.sensors[i];
    const std::string& name = whole.sensors[i].becomes;
    robot_formats::BodyDescription* body = body_of(description, sensor.frame);
    if (!body || name.empty() || !sensor.object_kind.empty()) continue;
    if (sensor.kind == "imu") add_imu(description, *body, sensor, name, doubles);
    if (sensor.kind == "camera") add_camera(description, *body, sensor, name, doubles);
  }
  return doubles;
}

}  // namespace murosimf::robot
