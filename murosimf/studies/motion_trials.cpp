#include "murosimf/studies/motion_trials.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/locomotion/keyframe_player.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"
#include "murosimf/scene/scene.h"
#include "murosimf/studies/parallel_runs.h"

namespace murosimf::studies {
namespace {

using locomotion::KeyframeMotion;

constexpr std::chrono::milliseconds between_looks(20);
constexpr double upright = 0.8, high = 0.85, down = 0.5;  // [1] cosine, share of the height, cosine
constexpr double rest = 1.2, rest_of_lying = 0.6;         // [s] after the motion
constexpr double usual_speed = 1.5;                       // [m/s] of a ball
constexpr double most_effort = 4;  // [1] of one joint: full_dynamics says what the motion would take

double rest_after(MotionGoal goal) { return goal == MotionGoal::lies ? rest_of_lying : rest; }

/// As the joints of the case play it: all values of a column are off by the same.
KeyframeMotion with_zero_errors(KeyframeMotion motion, const TuningCase& one) {
  constexpr double angle = 0.03, foot = 0.003;  // [rad], [m]
  for (std::size_t column = 0; column < motion.columns.size(); ++column) {
    const std::string& name = motion.columns[column][0].name;
    const bool is_place = name.find("_foot.") != std::string::npos && !name.ends_with(".pitch");
    const double error = (is_place ? foot : angle) * zero_error(one, column);
    motion.start[column] += error;
    for (locomotion::KeyFrame& frame : motion.frames) frame.values[column] += error;
  }
  return motion;
}

/// Observations of one robot in one run.
struct Observed {
  double uprightness = 0, seen_at_end = 0;  // sum, number
  bool stood = true, fell = false, lies = false, whole = true;
  double down_at = 1e9;   // [s]
  double way = 0;         // [m] in the wanted direction
  double ball_speed = 0;  // [m/s]
  double effort = 0, efforts = 0;
};

double mean(double sum, double number) { return number > 0 ? sum / number : 0; }

MotionOutcome judged(const Observed& seen, const MotionTask& task, double height, double haste, double duration) {
  const double extra = 0.05 * mean(seen.effort, seen.efforts) + 0.05 * haste + 0.02 * duration;
  MotionOutcome outcome;
  double cost = 0;
  if (task.goal == MotionGoal::stands) {
    outcome.good = seen.whole && seen.stood;
    cost = 1 - mean(seen.uprightness, seen.seen_at_end);
  } else if (task.goal == MotionGoal::kicks) {
    outcome.good = seen.whole && seen.stood && !seen.fell;
    cost = usual_speed / (usual_speed + seen.ball_speed);
  } else {
    outcome.good = seen.whole && seen.lies;
    cost = std::min(1.0, seen.down_at) + 0.5 * (1 - std::clamp(seen.way / height, 0.0, 1.0));
  }
  outcome.cost = (outcome.good ? 0 : 1) + cost + extra;
  // Numbers that broke down count as the worst: NaN must not lead a search.
  if (!seen.whole || !std::isfinite(outcome.cost)) outcome = {.good = false, .cost = 3};
  return outcome;
}

}  // namespace

/// Some robots under one of the circumstances, each with a motion of its own.
struct MotionTrials::World {
  World(scene_file::SceneSpec spec, const std::shared_ptr<scene::Assets>& assets, const MotionTask& what,
        const KeyframeMotion& motion)
      : task(what), scene(std::move(spec), {.cameras = false, .assets = assets, .stop = what.stop}) {
    for (const scene_file::RobotSpec& robot : scene.spec().robots) {
      Entity& entity = scene.simulation().world().entity(robot.name);
      robots.push_back(&entity);
      players.push_back(&scene.simulation().attach<locomotion::KeyframePlayer>(robot.name + "_player", entity,
                                                                               locomotion::KeyframePlayer::rate_hz,
                                                                               motion));
    }
    if (scene.spec().ball) ball = &scene.simulation().world().entity("ball");
    MUROSIMF_ASSERT(!robots.empty() && robots.size() == players.size());
    for (const int joint : robots[0]->model().joints()) {
      const Servo* servo = robots[0]->model().find(properties::servo, joint);
      if (servo && servo->stall_torque > 0) joints.push_back({joint, servo->stall_torque});
    }
  }

  /// Observations, motion by motion; empty: stopped.
  std::vector<Observed> run(std::span<const KeyframeMotion> motions) {
    MUROSIMF_ASSERT(!motions.empty() && motions.size() <= players.size());
    double longest = 0;
    for (std::size_t i = 0; i < players.size(); ++i) {
      const KeyframeMotion& motion = motions[std::min(i, motions.size() - 1)];
      players[i]->play(motion);
      longest = std::max(longest, duration(motion));
    }
    scene.reset();
    begins.clear();
    for (Entity* robot : robots) begins.push_back(robot->base().get(properties::position));
    std::vector<Observed> seen(motions.size());
    const double end = longest + rest_after(task.goal);
    while (seconds(scene.simulation().now()) < end) {
      scene.simulation().run(between_looks);
      if (scene.simulation().stopped()) return {};
      for (std::size_t i = 0; i < seen.size(); ++i) look(i, duration(motions[i]), seen[i]);
    }
    return seen;
  }

  void look(std::size_t i, double motion_time, Observed& seen) {
    MUROSIMF_ASSERT(i < robots.size() && i < begins.size());
    const double now = seconds(scene.simulation().now());
    if (now > motion_time + rest_after(task.goal) + 1e-9) return;
    ObjectAccess base = robots[i]->base();
    const Vec3d place = base.get(properties::position);
    const double cosine = base.get(properties::orientation).z.z;
    if (robots[i]->frozen() || !std::isfinite(place.z + cosine)) seen.whole = false;
    if (!seen.whole) return;
    const double heading = scene.spec().robots[i].heading + task.direction;
    const Vec3d toward{std::cos(heading), std::sin(heading), 0};
    if (cosine < down) {
      seen.fell = true;
      seen.down_at = std::min(seen.down_at, now);
    }
    seen.lies = cosine < down;
    seen.way = dot(place - begins[i], toward);
    if (ball) seen.ball_speed = std::max(seen.ball_speed, dot(ball->base().get(properties::linear_velocity), toward));
    // Only the rest after the motion shows whether the robot stands.
    if (now > motion_time) {
      seen.uprightness += 0.5 * std::max(-0.2, cosine) + 0.5 * std::min(1.0, place.z / height);
      seen.seen_at_end += 1;
      if (cosine < upright || place.z < high * height) seen.stood = false;
    }
    add_effort(*robots[i], seen);
  }

  /// Levels without torques have no effort: their share of the cost is 0.
  void add_effort(Entity& robot, Observed& seen) const {
    if (!robot.find(properties::joint_torque) || joints.empty()) return;
    double sum = 0;
    for (const Joint& joint : joints) {
      const double share = ObjectAccess(robot, joint.object).get(properties::joint_torque) / joint.stall;
      sum += std::min(share * share, most_effort);
    }
    seen.effort += sum / static_cast<double>(joints.size());
    seen.efforts += 1;
  }

  struct Joint {
    int object;
    double stall;  // [N m]
  };
  MotionTask task;
  scene::Scene scene;
  std::vector<Entity*> robots;
  std::vector<locomotion::KeyframePlayer*> players;
  std::vector<Joint> joints;
  Entity* ball = nullptr;
  double height = 1;
  std::vector<Vec3d> begins;
};

MotionTrials::MotionTrials(const VariedRobot& robot, const KeyframeMotion& motion, MotionTask task)
    : robot_(robot), motion_(motion), task_(std::move(task)), space_(robot.model(), motion, task_.fastest) {
  // Height of the base above the ground when the robot stands as in the last frame.
  MUROSIMF_ASSERT(!motion.frames.empty());
  KeyframeMotion last = motion;
  last.start = motion.frames.back().values;
  scene_file::SceneSpec spec = row_of_robots(robot_, {.level = "simplified_dynamics"}, 1);
  spec.robots[0].controller = "none";
  World stance(std::move(spec), robot_.assets(1, 1), task_, last);
  stance.scene.simulation().initialize();
  height_ = stance.robots[0]->base().get(properties::position).z;
}

MotionTrials::~MotionTrials() = default;

/// The errors of the case are in the robot's posture, its model and the ground.
std::unique_ptr<MotionTrials::World> MotionTrials::make_world(const TuningCase& one, std::size_t count) const {
  scene_file::SceneSpec spec = row_of_robots(robot_, one, count);
  for (scene_file::RobotSpec& each : spec.robots) {
    each.controller = "none";
    each.roll += task_.roll;
    each.pitch += task_.pitch;
  }
  if (task_.goal == MotionGoal::kicks) {
    scene_file::BallSpec ball;
    static_cast<scene_file::BallOptions&>(ball) = task_.ball_options;
    ball.position = rotation_z(one.heading) * (task_.ball + one.ball);
    spec.ball = ball;
  }
  auto world = std::make_unique<World>(std::move(spec), robot_.assets(one.mass, one.gain), task_, motion_);
  world->height = height_;
  return world;
}

std::vector<std::vector<MotionOutcome>> MotionTrials::run(const std::vector<KeyframeMotion>& motions,
                                                          const std::vector<TuningCase>& cases) {
  const std::size_t rows = (motions.size() + robots_in_a_row - 1) / robots_in_a_row;
  std::vector<double> haste;
  for (const KeyframeMotion& motion : motions) {
    double sum = 0;
    for (const double share : space_.rate_shares(motion)) sum += share * share;
    haste.push_back(sum / static_cast<double>(motion.frames.size()));
  }
  std::vector<std::vector<MotionOutcome>> all(motions.size(), std::vector<MotionOutcome>(cases.size()));
  // Worlds are kept: a search tries the same cases in every generation.
  const std::size_t needed = rows * cases.size();
  if (worlds_.size() < needed) worlds_.resize(needed);
  worlds_of_.resize(worlds_.size());
  run_in_parallel(needed, task_.threads, task_.stop, [&](std::size_t i) {
    const std::size_t which = i / rows, first = i % rows * robots_in_a_row;
    const TuningCase& one = cases[which];
    MUROSIMF_ASSERT(which < cases.size() && first < motions.size());
    const std::size_t count = std::min(robots_in_a_row, motions.size() - first);
    const std::size_t robots = task_.goal == MotionGoal::kicks ? 1 : count;  // there is one ball: one after the other
    // Everything that the world depends on: only with the same values it can be used again.
    const std::string key = fmt::format("{} {} {} {} {} {} {} {} {} {}", one.level, one.friction, one.mass, one.gain,
                                        one.roll, one.pitch, one.heading, one.ball.x, one.ball.y, robots);
    if (!worlds_[i] || worlds_of_[i] != key) {
      worlds_[i] = make_world(one, robots);
      worlds_of_[i] = key;
    }
    std::vector<KeyframeMotion> played;
    for (std::size_t k = 0; k < count; ++k) played.push_back(with_zero_errors(motions[first + k], one));
    std::vector<Observed> seen;
    for (std::size_t k = 0; k < count; k += robots) {
      const std::vector<Observed> some = worlds_[i]->run(std::span(played).subspan(k, robots));
      if (some.empty()) return;  // stopped
      seen.insert(seen.end(), some.begin(), some.end());
    }
    MUROSIMF_ASSERT(seen.size() == count);
    for (std::size_t k = 0; k < seen.size(); ++k) {
      const std::size_t m = first + k;
      all[m][which] = judged(seen[k], task_, height_, haste[m], duration(motions[m]));
    }
  });
  if (task_.stop && task_.stop()) return {};
  return all;
}

}  // namespace murosimf::studies
