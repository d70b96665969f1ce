#include "murosimf/scene/scene_cameras.h"

#include <algorithm>
#include <thread>

#include "murosimf/appearance/entity_appearance.h"
#include "murosimf/catalog/algorithm_catalog.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
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

constexpr int fine_samples = 4;       // to a pixel, from which on pictures for people are fine
constexpr unsigned most_threads = 8;  // for pictures for people

/// `make`: from appearances, std::unique_ptr to a renderer.
template <class Make>
auto make_renderer_of(SceneParts& parts, const Make& make) {
  appearance::AppearanceLibrary library;
  auto renderer = make([&](const Entity& entity) { return library.appearance(entity); });
  for (const std::string& warning : library.warnings()) {  // several renderers report the same
    if (!parts.diagnostics.has_warning(warning)) parts.diagnostics.warn(warning);
  }
  renderer->locate();
  return renderer;
}

}  // namespace

std::unique_ptr<render::Renderer> make_renderer(SceneParts& parts, const scene_file::LightSpec& light) {
  render::RendererOptions options{light_of(light), light.samples, light.samples >= fine_samples};
  options.threads = static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1U, most_threads));
  return make_renderer_of(parts, [&](const render::AppearanceOf& appearance) {
    return render::make_renderer(parts.simulation->world(), parts.moving_entities, appearance, options);
  });
}

std::unique_ptr<render::SoftwareRenderer> make_camera_renderer(SceneParts& parts, const scene_file::LightSpec& light) {
  const render::RendererOptions options{light_of(light), light.samples};
  return make_renderer_of(parts, [&](const render::AppearanceOf& appearance) {
    return std::make_unique<render::SoftwareRenderer>(parts.simulation->world(), parts.moving_entities, appearance,
                                                      options);
  });
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
