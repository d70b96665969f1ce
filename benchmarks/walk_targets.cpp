/// walk_targets - what the walk engine asks of the joints, as JSON, so that another engine can replay it.
///
/// Usage: murosimf_walk_targets <seconds> <forward> <left> <turn>: a walk of the scene "walk" with this command in
/// m/s, m/s, rad/s. `start` is the pose of the base before the first step: position [m], quaternion w x y z; joints
/// start at the first targets. `targets` has a row per control cycle of `period` [s], in the order of `joints`.
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "murosimf/locomotion/walk_engine.h"
#include "murosimf/model/properties.h"
#include "murosimf/motion/motion_properties.h"
#include "murosimf/scene/scene.h"

namespace {

using namespace murosimf;

using nlohmann::ordered_json;

ordered_json start_of(Entity& robot) {
  const Vec3d r = robot.base().get(properties::position);
  const Quaterniond Q = robot.base().get(properties::base_quaternion);
  return {r.x, r.y, r.z, Q.w, Q.x, Q.y, Q.z};
}

double duration_of(const std::string& text) {
  char* end = nullptr;
  const double s = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != 0 || !(s > 0 && s <= 1e4)) {
    throw std::invalid_argument("seconds '" + text + "': write a number from 0 to 10000");
  }
  return s;
}

void dump(double duration, const std::string& command) {
  scene::Scene scene("walk", {.overrides = {"walker.level=articulated_dynamics", "walker.command=" + command}});
  Simulation& simulation = scene.simulation();
  Entity& robot = simulation.world().entity("walker");
  simulation.initialize();
  const ordered_json start = start_of(robot);
  const auto& targets = robot.find(properties::joint_target)->values;
  const Duration cycle = from_seconds(1 / locomotion::WalkEngine::rate_hz);

  std::vector<std::string> names;
  std::vector<std::vector<double>> rows;
  for (const int i : robot.model().joints()) names.push_back(robot.model().objects()[i].name);
  while (seconds(simulation.now()) < duration) {
    simulation.run(cycle);
    std::vector<double> row;
    for (const int i : robot.model().joints()) row.push_back(targets[i]);
    rows.push_back(std::move(row));
  }
  const ordered_json walk{{"period", seconds(cycle)}, {"start", start}, {"joints", names}, {"targets", rows}};
  fmt::print("{}\n", walk.dump());
}

}  // namespace

int main(int count, char** arguments) {
  try {
    if (count != 5) throw std::invalid_argument("usage: murosimf_walk_targets <seconds> <forward> <left> <turn>");
    dump(duration_of(arguments[1]), fmt::format("[{}, {}, {}]", arguments[2], arguments[3], arguments[4]));
  } catch (const std::exception& error) {
    fmt::print(stderr, "murosimf_walk_targets: {}\n", error.what());
    return 1;
  }
}
