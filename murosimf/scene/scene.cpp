#include "murosimf/scene/scene.h"

#include <utility>

#include <fmt/format.h>

#include "murosimf/files/data_path.h"
#include "murosimf/scene/scene_addition.h"
#include "murosimf/scene/scene_batch.h"
#include "murosimf/scene/scene_builder.h"
#include "murosimf/scene/scene_exchange.h"
#include "murosimf/scene/scene_presence.h"
#include "murosimf/scene/scene_start.h"
#include "murosimf/scene/scene_state.h"
#include "murosimf/scene_file/remote_override.h"
#include "murosimf/scene_file/scene_change.h"

namespace murosimf::scene {
namespace {

scene_file::SceneSpec read(const std::filesystem::path& name, const SceneOptions& options) {
  const files::FileScope scope(options.files);
  const auto file = files::find_data_file(name.string(), "scenes", ".toml");
  if (options.files.only_from) {
    for (const std::string& text : options.overrides) scene_file::check_remote_override(text, file.parent_path());
  }
  return scene_file::read_scene(file, options.overrides, options.events, options.pushes);
}

scene_file::SceneSpec with_seed(scene_file::SceneSpec spec, const SceneOptions& options) {
  if (options.seed) spec.seed = *options.seed;
  return spec;
}

}  // namespace

Scene::Scene(const std::filesystem::path& name, const SceneOptions& options) : Scene(read(name, options), options) {}

Scene::Scene(scene_file::SceneSpec spec, const SceneOptions& options)
    : parts_(with_seed(std::move(spec), options), options.threads) {
  const files::FileScope scope(options.files);
  parts_.simulation->use_lanes(options.lanes);
  build(parts_, options);
}

void Scene::exchange_level(std::string_view robot, std::string_view level) {
  scene::exchange_level(parts_, robot, level);
}

void Scene::exchange_contact(std::string_view entity, std::string_view law) {
  scene::exchange_contact(parts_, entity, law);
}

void Scene::exchange_servo_law(std::string_view robot, std::string_view law) {
  scene::exchange_servo_law(parts_, robot, law);
}

Entity& Scene::add(scene_file::RobotSpec robot) { return scene::add(parts_, std::move(robot)); }
Entity& Scene::add(scene_file::BodySpec body) { return scene::add(parts_, std::move(body)); }

void Scene::enter(std::string_view entity) { scene::enter(parts_, entity); }
void Scene::leave(std::string_view entity) { scene::leave(parts_, entity); }

std::future<void> Scene::post(std::string change) {
  const auto event = [this, change] { return scene_file::read_change(parts_.spec, change); };
  // checked when it is posted as well: the caller gets errors of spelling at once
  return parts_.simulation->command_queue().post(
      change, [this, event] { apply_change(parts_, event()); }, [this, event] { check_change(parts_, event()); });
}

void Scene::change(const std::vector<std::string>& changes) { change_all(parts_, changes); }

void Scene::reset(std::optional<std::uint64_t> seed) { scene::reset(parts_, seed); }

std::vector<std::byte> Scene::save() { return save_state(parts_); }
void Scene::load(std::span<const std::byte> bytes) { load_state(parts_, bytes); }

/// With all digits: the repeated command must come in the same step.
std::vector<std::string> events_of_commands(const std::vector<Command>& commands) {
  std::vector<std::string> events;
  for (const Command& command : commands) {
    events.push_back(fmt::format("{:.9f}:{}", seconds(command.time), command.text));
  }
  return events;
}

}  // namespace murosimf::scene
