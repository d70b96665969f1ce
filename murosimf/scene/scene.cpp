#include "murosimf/scene/scene.h"

#include "murosimf/files/data_path.h"
#include "murosimf/scene/scene_builder.h"
#include "murosimf/scene/scene_exchange.h"
#include "murosimf/scene/scene_state.h"

namespace murosimf::scene {
namespace {

scene_file::SceneSpec read(const std::filesystem::path& name, const SceneOptions& options) {
  const auto file = files::find_data_file(name.string(), "scenes", ".toml");
  scene_file::SceneSpec spec = scene_file::read_scene(file, options.overrides, options.events, options.pushes);
  if (options.seed) spec.seed = *options.seed;
  return spec;
}

}  // namespace

Scene::Scene(const std::filesystem::path& name, const SceneOptions& options)
    : parts_(read(name, options), options.threads) {
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

std::vector<std::byte> Scene::save() { return save_state(parts_); }
void Scene::load(std::span<const std::byte> bytes) { load_state(parts_, bytes); }

}  // namespace murosimf::scene
