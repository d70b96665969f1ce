// Who draws the scene for its cameras, and for people.
#include <algorithm>

#include <fmt/format.h>

#include "murosimf/appearance/entity_appearance.h"
#include "murosimf/render/renderer.h"
#include "murosimf/scene/registry.h"
#include "murosimf/scene/scene.h"

namespace murosimf::scene {
namespace {

render::Light light_of(const LightSpec& spec) {
  render::Light light = find_entry(render::lights(), "light", spec.name).light;
  if (spec.toward) light.toward = *spec.toward;
  for (Color* color : {&light.lamp, &light.sky, &light.ground}) {
    *color = {spec.brightness * color->red, spec.brightness * color->green, spec.brightness * color->blue};
  }
  light.shadows = spec.shadows;
  return light;
}

}  // namespace

Scene::~Scene() = default;

std::unique_ptr<render::Renderer> Scene::make_renderer(const LightSpec& light) {
  appearance::AppearanceLibrary library;
  auto renderer = std::make_unique<render::Renderer>(
      simulation_->world(), moving_entities_, [&](const Entity& entity) { return library.appearance(entity); },
      render::RendererOptions{light_of(light), light.samples});
  for (const std::string& warning : library.warnings()) {  // of several renderers
    if (std::ranges::find(warnings_, warning) == warnings_.end()) warnings_.push_back(warning);
  }
  renderer->locate();
  return renderer;
}

sensors::ViewSource* Scene::view_source() {
  if (!options_.cameras || cannot_draw_) return nullptr;
  if (renderer_) return renderer_.get();
  try {
    renderer_ = make_renderer(spec_.light);
    notes_.push_back(fmt::format("cameras: drawn by {}", renderer_->name()));
  } catch (const SetupError& error) {
    cannot_draw_ = true;
    warnings_.push_back(fmt::format("cameras have no frames: {}", error.what()));
  }
  return renderer_.get();
}

}  // namespace murosimf::scene
