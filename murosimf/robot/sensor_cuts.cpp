#include "murosimf/robot/sensor_cuts.h"

#include <algorithm>

namespace murosimf::robot {
namespace {

bool is_cut(const robot_formats::SensorDescription& sensor) {
  return sensor.kind == "force_torque" || sensor.kind == "force" || sensor.kind == "torque";
}

/// The body with a joint or a frame of this name, or of this name itself.
const robot_formats::BodyDescription* body_with(const robot_formats::RobotDescription& description,
                                                const std::string& name) {
  const auto has = [&](const robot_formats::BodyDescription& body) {
    return std::ranges::find(body.joints, name, &robot_formats::JointDescription::name) != body.joints.end() ||
           std::ranges::find(body.frames, name, &robot_formats::FrameDescription::name) != body.frames.end();
  };
  const auto& bodies = description.bodies;
  auto found = std::ranges::find_if(bodies, has);
  if (found == bodies.end()) found = std::ranges::find(bodies, name, &robot_formats::BodyDescription::name);
  return found == bodies.end() ? nullptr : &*found;
}

/// The value of a key that is a name; empty: none.
std::string word(const component_files::SensorTable& table, const std::string& key) {
  const auto found = table.values.find(key);
  const auto* text = found == table.values.end() ? nullptr : std::get_if<std::string>(&found->second.is);
  return text ? *text : "";
}

}  // namespace

std::set<std::string> find_cuts(robot_formats::RobotDescription& description, const RobotConfig& table) {
  std::set<std::string> bodies;
  for (robot_formats::SensorDescription& sensor : description.sensors) {
    if (!is_cut(sensor)) continue;
    const robot_formats::BodyDescription* body = body_with(description, sensor.frame);
    if (body) bodies.insert(sensor.behind = body->name);
  }
  for (const component_files::SensorTable& sensor : table.sensors) {
    const std::string behind = word(sensor, "behind");
    if (behind.empty() && word(sensor, "type") != "joint_wrench") continue;
    const robot_formats::BodyDescription* body =
        body_with(description, behind.empty() ? word(sensor, "frame") : behind);
    if (body) bodies.insert(body->name);
  }
  return bodies;
}

}  // namespace murosimf::robot
