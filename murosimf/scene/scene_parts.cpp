#include "murosimf/scene/scene_parts.h"

#include "murosimf/model/error.h"

namespace murosimf::scene {

SceneParts::SceneParts(scene_file::SceneSpec what, int threads)
    : spec(std::move(what)), simulation(std::make_unique<Simulation>(threads)) {}

SceneParts::~SceneParts() = default;

const scene_file::BodySpec* body_spec(const scene_file::SceneSpec& spec, const Entity& entity) {
  for (const scene_file::BodySpec& body : spec.bodies) {
    if (body.name == entity.name()) return &body;
  }
  return nullptr;
}

scene_file::RobotSpec& robot_spec(scene_file::SceneSpec& spec, std::string_view robot) {
  std::vector<std::string_view> names;
  for (scene_file::RobotSpec& known : spec.robots) {
    if (known.name == robot) return known;
    names.push_back(known.name);
  }
  throw SetupError(unknown_name("robot", robot, names));
}

}  // namespace murosimf::scene
