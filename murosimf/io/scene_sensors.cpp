// Which sensors the robots of a scene carry: those of their files, changed by the scene.
#include <algorithm>

#include <fmt/format.h>

#include "murosimf/io/scene.h"
#include "murosimf/io/sensor_types.h"

namespace murosimf::io {
namespace {

/// Calls `f`; a SetupError that it throws says at its end which robot it is about.
template <class F>
void about(const std::string& robot, const F& f) {
  try {
    f();
  } catch (const SetupError& error) {
    throw SetupError(fmt::format("{} (robot '{}')", error.what(), robot));
  }
}

}  // namespace

std::vector<sensors::SensorSpec> Scene::sensors_of(const RobotSpec& robot) const {
  std::vector<sensors::SensorSpec> specs;
  if (!robot.sensors.none) specs = models_.at(robot.model).sensors;
  change_sensors(specs, robot.sensors.tables, spec_.file.parent_path());
  return specs;
}

void Scene::attach_sensors() {
  const sensors::SensorSurroundings surroundings{spec_.seed, movers_};
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    std::vector<const sensors::Sensor*>& attached = sensors_.emplace_back();
    about(spec_.robots[i].name, [&] {
      for (const sensors::SensorSpec& spec : sensors_of(spec_.robots[i])) {
        attached.push_back(&attach_sensor(*simulation_, *robots_[i], spec, surroundings, spec_.rate));
      }
    });
  }
}

void Scene::warn_about_sensors(const RobotSpec& robot) {
  const auto same = [&](const RobotSpec& spec) { return spec.name == robot.name; };
  const auto number = std::find_if(spec_.robots.begin(), spec_.robots.end(), same) - spec_.robots.begin();
  std::vector<std::pair<std::string, std::vector<std::string>>> remarks;  // and the sensors that they are about
  for (const sensors::Sensor* sensor : sensors_[static_cast<std::size_t>(number)]) {
    const std::string remark = sensor->remark(robot.level);
    if (remark.empty()) continue;
    auto known = std::find_if(remarks.begin(), remarks.end(), [&](const auto& r) { return r.first == remark; });
    if (known == remarks.end()) known = remarks.insert(remarks.end(), {remark, {}});
    known->second.push_back(sensor->reading().info->name);
  }
  if (remarks.empty()) return;
  std::string text;
  for (const auto& [remark, names] : remarks) {
    text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", fmt::join(names, ", "), remark);
  }
  const std::string line = fmt::format("{}: sensors at {}: {}", robot.name, robot.level, text);
  if (std::find(warnings_.begin(), warnings_.end(), line) == warnings_.end()) warnings_.push_back(line);
}

}  // namespace murosimf::io
