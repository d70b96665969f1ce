#include "murosimf/scene/scene_cameras.h"

#include <fmt/format.h>

#include "murosimf/appearance/entity_appearance.h"
#include "murosimf/catalog/algorithm_catalog.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/render/renderer.h"
#include "murosimf/scene/scene_parts.h"

namespace murosimf::scene {
render::Light light_of(const scene_file::LightSpec& spec) {
  MUROSIMF_ASSERT(spec.brightness >= 0);
  render::Light light = find_entry(render::lights(), "light", spec.name).light;
  if (spec.toward) light.toward = *spec.toward;
  for (Color* color : {&light.lamp, &light.sky, &light.ground, &light.others[0].lamp, &light.others[1].lamp}) {
    *color = {spec.brightness * color->red, spec.brightness * color->green, spec.brightness * color->blue};
  }
  light.shadows = spec.shadows;
  return light;
}

std::unique_ptr<render::Renderer> make_renderer(SceneParts& parts, const scene_file::LightSpec& light) {
  appearance::AppearanceLibrary library;
  auto renderer = std::make_unique<render::Renderer>(
      parts.simulation->world(), parts.moving_entities,
      [&](const Entity& entity) { return library.appearance(entity); },
      render::RendererOptions{light_of(light), light.samples});
  for (const std::string& warning : library.warnings()) {  // several renderers report the same
    if (!parts.diagnostics.has_warning(warning)) parts.diagnostics.warn(warning);
  }
  renderer->locate();
  return renderer;
}

CameraRenderer::CameraRenderer(SceneParts& parts) : parts_(parts) {}

CameraRenderer::~CameraRenderer() = default;

/// Made at the first picture: without a graphics driver, scenes without pictures must run.
sensors::ViewSource* CameraRenderer::view_source() {
  if (cannot_draw_) return nullptr;
  if (renderer_) return this;
  try {
    renderer_ = make_renderer(parts_, parts_.spec.light);
    parts_.diagnostics.note("cameras", fmt::format("drawn by {}", renderer_->name()));
  } catch (const SetupError& error) {
    cannot_draw_ = true;
    parts_.diagnostics.warn(fmt::format("cameras have no frames: {}", error.what()));
    return nullptr;
  }
  return this;
}

void CameraRenderer::renew() {
  if (renderer_) renderer_ = make_renderer(parts_, parts_.spec.light);
}

void CameraRenderer::renew_light() {
  const scene_file::LightSpec& light = parts_.spec.light;
  if (renderer_) renderer_->set_light(light_of(light), light.samples);
}

void CameraRenderer::draw(const sensors::Perspective& perspective, const sensors::Layers& layers, double ahead,
                          sensors::View& view) noexcept {
  MUROSIMF_ASSERT(renderer_ != nullptr);
  renderer_->draw(perspective, layers, ahead, view);
}

}  // namespace murosimf::scene
