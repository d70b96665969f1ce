// Which sensors the robots of a scene carry: those of their files, changed by the scene.
#include <algorithm>

#include <fmt/format.h>

#include "murosimf/components/sensor_types.h"
#include "murosimf/scene/scene.h"

namespace murosimf::scene {
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

/// The same sentence about several.
struct Remark {
  std::string text;
  std::vector<std::string> about;
};

void add_remark(const std::string& text, const std::string& about, std::vector<Remark>& remarks) {
  if (text.empty()) return;
  auto known = std::find_if(remarks.begin(), remarks.end(), [&](const Remark& r) { return r.text == text; });
  if (known == remarks.end()) known = remarks.insert(remarks.end(), {text, {}});
  known->about.push_back(about);
}

bool fits(const sensors::SensorSpec& spec, double step_rate) {
  try {
    sensors::check_rate(spec, step_rate);
  } catch (const SetupError&) {
    return false;
  }
  return true;
}

/// [Hz] The highest rate up to `rate` that steps divide into.
double rate_of_whole_steps(double rate, double step_rate) {
  const Duration step = from_seconds(1 / step_rate), period = from_seconds(1 / rate);
  return 1 / seconds((period + step - Duration{1}) / step * step);
}

}  // namespace

std::string Scene::fit_to_steps(sensors::SensorSpec& spec) const {
  // a rate that steps of usual length do not allow either is a mistake of the file
  if (fits(spec, spec_.rate) || !fits(spec, usual_step_rate)) return {};
  const double rate = rate_of_whole_steps(spec.rate, spec_.rate);
  const std::string remark = fmt::format("samples at {:.4g} Hz, not {:.4g}, because steps are {:.4g} ms long", rate,
                                         spec.rate, 1e3 / spec_.rate);
  spec.rate = rate;
  return remark;
}

std::vector<sensors::SensorSpec> Scene::sensors_of(const RobotSpec& robot) {
  std::vector<sensors::SensorSpec> specs;
  if (!robot.sensors.none) specs = models_.at(robot.model).sensors;
  std::vector<Remark> remarks;
  for (sensors::SensorSpec& spec : specs) add_remark(fit_to_steps(spec), spec.name, remarks);
  for (const Remark& remark : remarks) {
    note(robot, fmt::format("{}: {}", fmt::join(remark.about, ", "), remark.text));
  }
  components::change_sensors(specs, robot.sensors.tables, spec_.file.parent_path());
  return specs;
}

void Scene::attach_sensors() {
  const sensors::SensorSurroundings surroundings{spec_.seed, moving_entities_, [this] { return view_source(); }};
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    std::vector<const sensors::Sensor*>& attached = sensors_.emplace_back();
    about(spec_.robots[i].name, [&] {
      for (const sensors::SensorSpec& spec : sensors_of(spec_.robots[i])) {
        attached.push_back(&components::attach_sensor(*simulation_, *robots_[i], spec, surroundings, spec_.rate));
      }
    });
  }
}

/// "kinematic_walking: left_foot, right_foot: there are no ..."; empty if the level has all that the sensors show.
std::string Scene::sensor_remarks(const RobotSpec& robot) const {
  const auto same = [&](const RobotSpec& spec) { return spec.name == robot.name; };
  const auto number = std::find_if(spec_.robots.begin(), spec_.robots.end(), same) - spec_.robots.begin();
  std::vector<Remark> remarks;
  for (const sensors::Sensor* sensor : sensors_[static_cast<std::size_t>(number)]) {
    add_remark(sensor->remark(robot.level), sensor->reading().info->name, remarks);
  }
  std::string text;
  for (const Remark& remark : remarks) {
    text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", fmt::join(remark.about, ", "), remark.text);
  }
  return text.empty() ? "" : fmt::format("{}: {}", robot.level, text);
}

void Scene::note_about_sensors() {
  std::vector<Remark> remarks;
  for (const RobotSpec& robot : spec_.robots) {
    const std::string text = sensor_remarks(robot);
    add_remark(text, robot.name, remarks);
    said_.emplace(robot.name, text);
  }
  for (const Remark& remark : remarks) {
    notes_.push_back(fmt::format("{}: {}", fmt::join(remark.about, ", "), remark.text));
  }
}

void Scene::note_about_sensors(const RobotSpec& robot) {
  const std::string text = sensor_remarks(robot);
  if (!text.empty() && said_.emplace(robot.name, text).second) note(robot, text);
}

}  // namespace murosimf::scene
