#include "murosimf/dataset/posture_bank.h"

#include <span>

#include <fmt/format.h>

#include "murosimf/dataset/ground_reach.h"
#include "murosimf/math/assert.h"
#include "murosimf/math/hash.h"
#include "murosimf/math/scalar.h"
#include "murosimf/model/error.h"

namespace murosimf::dataset {
namespace {

constexpr auto between_records = std::chrono::milliseconds(50);
constexpr double get_up_time = 4;  // [s]
constexpr double upright = 0.8;    // [1] cosine of the base's tilt

/// Robots of one file, read with the same arguments, are of one kind: they have the same joints.
std::string kind_of(const scene_file::RobotSpec& robot) {
  std::string kind = fmt::format("{}\n{}", robot.model, robot.body);
  for (const auto& [name, value] : robot.xacro) kind += fmt::format("\n{}:={}", name, value);
  return kind;
}

Posture posture_of(const Model& model, const PoseFrame& frame, std::size_t first) {
  const auto size = static_cast<std::size_t>(model.size());
  const Mat3d& R = frame.orientation[first];
  Posture posture{.height = frame.position[first].z, .attitude = rotation_z(-heading(R)) * R};
  posture.reach = ground_reach(model, std::span(frame.position).subspan(first, size),
                               std::span(frame.orientation).subspan(first, size));
  const auto joints = std::span(frame.joint_position).subspan(first, size);
  posture.joints.assign(joints.begin(), joints.end());
  return posture;
}

void add(Hasher& hasher, const Posture& posture) {
  hasher.add(posture.height);
  hasher.add(posture.reach);
  for (const Vec3d& axis : {posture.attitude.x, posture.attitude.y, posture.attitude.z}) {
    for (const double number : {axis.x, axis.y, axis.z}) hasher.add(number);
  }
  for (const double joint : posture.joints) hasher.add(joint);
}

Doing doing_of(const Posture& posture, bool at_start) {
  if (posture.attitude.z.z < upright) return Doing::down;
  return at_start ? Doing::standing : Doing::moving;
}

/// The scene with this robot alone, which lies down and plays a motion.
scene_file::SceneSpec alone(const scene_file::SceneSpec& spec, const scene_file::RobotSpec& robot,
                            const std::string& motion, double pitch) {
  scene_file::SceneSpec result;
  result.file = spec.file;
  result.name = spec.name;
  result.seed = spec.seed;
  result.rate = spec.rate;
  scene_file::RobotSpec lying;
  lying.name = robot.name;
  lying.model = robot.model;
  lying.body = robot.body;
  lying.xacro = robot.xacro;
  lying.where = robot.where;
  lying.level = "simplified_dynamics";
  lying.controller = "keyframes";
  lying.motion = motion;
  lying.pitch = pitch;
  result.robots.push_back(lying);
  return result;
}

/// Where motions of the robot stand: in a folder with the name of its model, with or without a number at its end, or in none.
std::vector<std::string> motion_folders(const scene_file::RobotSpec& robot) {
  const std::string model = std::filesystem::path(robot.model).stem().string();
  const std::string family = model.substr(0, model.find_last_not_of("0123456789") + 1);
  return {model + "/", family + "/", ""};
}

}  // namespace

PostureBank::PostureBank(const scene_file::SceneSpec& spec, const scene::SceneOptions& options, double seconds) {
  scene::SceneOptions quiet = options;
  quiet.cameras = false;
  scene::Scene scene(spec, quiet);
  scene.simulation().initialize();
  record(scene, seconds, false);
  for (const scene_file::RobotSpec& robot : spec.robots) {
    Postures& known = kinds_[kind_of(robot)];
    if (!known[static_cast<std::size_t>(Doing::down)].empty() || seconds == 0) continue;
    record_get_up(spec, robot, quiet);
  }
}

const Postures& PostureBank::of(const scene_file::RobotSpec& robot) const { return kinds_.at(kind_of(robot)); }

std::uint64_t PostureBank::hash() const {
  Hasher hasher;
  for (const auto& [kind, postures] : kinds_) {
    for (const std::vector<Posture>& some : postures) {
      hasher.add(std::uint64_t{some.size()});
      for (const Posture& posture : some) add(hasher, posture);
    }
  }
  return hasher.value();
}

/// The first motion that fits the robot; one that none fits is only seen on its feet.
void PostureBank::record_get_up(const scene_file::SceneSpec& spec, const scene_file::RobotSpec& robot,
                                const scene::SceneOptions& options) {
  for (const auto& [motion, pitch] : {std::pair{"get_up_back", -pi / 2}, std::pair{"get_up_front", pi / 2}}) {
    for (const std::string& folder : motion_folders(robot)) {
      try {
        scene::Scene scene(alone(spec, robot, folder + motion, pitch), options);
        scene.simulation().initialize();
        record(scene, get_up_time, true);
        break;
      } catch (const SetupError&) {
        continue;
      }
    }
  }
}

void PostureBank::record(scene::Scene& scene, double seconds, bool only_down) {
  Simulation& simulation = scene.simulation();
  const auto& robots = scene.spec().robots;
  const auto& entities = simulation.world().entities();
  PoseFrame frame;
  bool at_start = true;
  for (const Duration end = simulation.now() + from_seconds(seconds); simulation.now() <= end; at_start = false) {
    simulation.poses().take(simulation.world(), simulation.now(), 0, frame);
    for (std::size_t i = 0; i < robots.size(); ++i) {
      const Entity* robot = scene.parts().robots[i];
      if (robot->idle()) continue;
      const auto place = static_cast<std::size_t>(
          std::ranges::find(entities, robot, [](const auto& one) { return one.get(); }) - entities.begin());
      MUROSIMF_ASSERT(place + 1 < frame.first.size());
      MUROSIMF_ASSERT(frame.first[place] + static_cast<std::size_t>(robot->model().size()) == frame.first[place + 1]);
      Posture posture = posture_of(robot->model(), frame, frame.first[place]);
      const Doing doing = doing_of(posture, at_start);
      if (only_down && doing != Doing::down) continue;
      kinds_[kind_of(robots[i])][static_cast<std::size_t>(doing)].push_back(std::move(posture));
    }
    const Duration before = simulation.now();
    simulation.run(between_records);
    if (simulation.now() == before) break;  // it was told to stop
  }
}

}  // namespace murosimf::dataset
