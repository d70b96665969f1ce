#include "murosimf/series/walk_trials.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "murosimf/model/properties.h"
#include "murosimf/scene/scene.h"
#include "murosimf/series/parallel_runs.h"

namespace murosimf::series {
namespace {

constexpr std::chrono::milliseconds between_walk_looks(50);
constexpr double fallen = 0.5;                   // [1] cosine of the lean
constexpr double start_up = 2, start_share = 4;  // [s], [1] of the duration

double heading_of(Entity& robot) {
  const Mat3d R = robot.base().get(properties::orientation);
  return std::atan2(R.x.y, R.x.x);
}

double wrapped(double angle) { return std::remainder(angle, 2 * pi); }

/// How far a robot comes in its own frame.
class WalkWatch {
 public:
  WalkWatch(Entity& robot, const Vec3d& command, double duration)
      : robot_(robot), command_(command), duration_(duration), from_(std::min(start_up, duration / start_share)) {}

  void look(double now) {
    const Vec3d place = robot_.base().get(properties::position);
    const double cosine = robot_.base().get(properties::orientation).z.z, heading = heading_of(robot_);
    if (robot_.frozen() || !std::isfinite(place.x + place.y + cosine) || cosine < fallen)
      fell_at_ = std::min(fell_at_, now);
    if (now > from_ + 1e-9) {
      const double turned = wrapped(heading - heading_), middle = heading_ + 0.5 * turned;
      way_ += rotation_z(-middle) * (place - place_);
      turned_ += turned;
    }
    place_ = place;
    heading_ = heading;
  }

  [[nodiscard]] WalkOutcome outcome() const {
    if (fell_at_ <= duration_) return {.fell = true, .cost = 2 - fell_at_ / duration_};
    const double time = duration_ - from_;
    const double along = std::hypot(way_.x / time - command_.x, way_.y / time - command_.y);
    const double s = std::max(std::hypot(command_.x, command_.y), 0.1), u = std::max(std::abs(command_.z), 0.5);
    return {.fell = false, .cost = std::min(1.0, std::hypot(along / s, (turned_ / time - command_.z) / u))};
  }

 private:
  Entity& robot_;
  Vec3d command_;
  double duration_, from_;
  Vec3d place_, way_;
  double heading_ = 0, turned_ = 0, fell_at_ = HUGE_VAL;
};

/// Of some candidates in one case; empty: stopped.
std::vector<WalkOutcome> walk_in_a_row(const VariedRobot& robot, const WalkTask& task, const Vec3d& command,
                                       std::span<const OptionValues> candidates, const TuningCase& one) {
  scene_file::SceneSpec spec = row_of_robots(robot, one, candidates.size());
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    spec.robots[i].controller = "walk";
    spec.robots[i].options = candidates[i];
    spec.robots[i].command = command;
  }
  scene::Scene scene(std::move(spec),
                     {.cameras = false, .assets = robot.assets(one.mass, one.gain), .stop = task.stop});
  Simulation& simulation = scene.simulation();
  std::vector<WalkWatch> watches;
  for (const auto& each : scene.spec().robots)
    watches.emplace_back(simulation.world().entity(each.name), command, task.duration);
  while (seconds(simulation.now()) < task.duration - 1e-9) {
    simulation.run(between_walk_looks);
    if (simulation.stopped()) return {};
    for (WalkWatch& watch : watches) watch.look(seconds(simulation.now()));
  }
  std::vector<WalkOutcome> outcomes;
  for (const WalkWatch& watch : watches) outcomes.push_back(watch.outcome());
  return outcomes;
}

}  // namespace

std::vector<std::vector<WalkOutcome>> walk_trials(const VariedRobot& robot, const WalkTask& task,
                                                  const std::vector<OptionValues>& candidates,
                                                  const std::vector<TuningCase>& cases) {
  const std::size_t rows = (candidates.size() + robots_in_a_row - 1) / robots_in_a_row;
  std::vector<std::vector<WalkOutcome>> all(candidates.size(), std::vector<WalkOutcome>(cases.size()));
  run_in_parallel(rows * cases.size(), task.threads, task.stop, [&](std::size_t i) {
    const std::size_t which = i / rows, first = i % rows * robots_in_a_row;
    const std::size_t count = std::min(robots_in_a_row, candidates.size() - first);
    const auto row = std::span(candidates).subspan(first, count);
    const auto outcomes = walk_in_a_row(robot, task, task.commands[which % task.commands.size()], row, cases[which]);
    for (std::size_t k = 0; k < outcomes.size(); ++k) all[first + k][which] = outcomes[k];
  });
  if (task.stop && task.stop()) return {};
  return all;
}

}  // namespace murosimf::series
