#include "murosimf/scene/scene_cameras.h"

#include "murosimf/appearance/entity_appearance.h"
#include "murosimf/catalog/algorithm_catalog.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/render/renderer.h"
#include "murosimf/render/software_renderer.h"
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

namespace {

/// Of one of the two renderers.
template <class AnyRenderer>
std::unique_ptr<AnyRenderer> make_renderer_of(SceneParts& parts, const render::RendererOptions& options) {
  appearance::AppearanceLibrary library;
  auto renderer = std::make_unique<AnyRenderer>(
      parts.simulation->world(), parts.moving_entities,
      [&](const Entity& entity) { return library.appearance(entity); }, options);
  for (const std::string& warning : library.warnings()) {  // several renderers report the same
    if (!parts.diagnostics.has_warning(warning)) parts.diagnostics.warn(warning);
  }
  renderer->locate();
  return renderer;
}

}  // namespace

std::unique_ptr<render::Renderer> make_renderer(SceneParts& parts, const scene_file::LightSpec& light) {
  return make_renderer_of<render::Renderer>(parts, {light_of(light), light.samples});
}

std::unique_ptr<render::SoftwareRenderer> make_camera_renderer(SceneParts& parts, const scene_file::LightSpec& light) {
  return make_renderer_of<render::SoftwareRenderer>(parts, {light_of(light), light.samples});
}

CameraRenderer::CameraRenderer(SceneParts& parts) : parts_(parts) {}

CameraRenderer::~CameraRenderer() = default;

/// Made at the first picture: scenes without pictures need no meshes.
sensors::ViewSource* CameraRenderer::view_source() {
  if (!renderer_) renderer_ = make_camera_renderer(parts_, parts_.spec.light);
  return this;
}

void CameraRenderer::renew() {
  if (renderer_) renderer_ = make_camera_renderer(parts_, parts_.spec.light);
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
