#include "murosimf/scene/scene_parts.h"

#include "murosimf/model/error.h"

namespace murosimf::scene {

SceneParts::SceneParts(SceneSpec what, int threads)
    : spec(std::move(what)), simulation(std::make_unique<Simulation>(threads)) {}

SceneParts::~SceneParts() = default;

const BodySpec* body_spec(const SceneSpec& spec, const Entity& entity) {
  for (const BodySpec& body : spec.bodies) {
    if (body.name == entity.name()) return &body;
  }
  return nullptr;
}

RobotSpec& robot_spec(SceneSpec& spec, std::string_view robot) {
  std::vector<std::string_view> names;
  for (RobotSpec& known : spec.robots) {
    if (known.name == robot) return known;
    names.push_back(known.name);
  }
  throw SetupError(unknown_name("robot", robot, names));
}

}  // namespace murosimf::scene
