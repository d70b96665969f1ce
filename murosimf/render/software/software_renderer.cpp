#include "murosimf/render/software_renderer.h"

#include "murosimf/render/software/software_drawing.h"

namespace murosimf::render {
namespace {

using software::SoftwareDrawing;
using software::Stage;

}  // namespace

struct SoftwareRenderer::Drawings {
  /// One that no thread draws with, or a new one.
  std::unique_ptr<SoftwareDrawing> take(const RenderScene& scene) {
    {
      const std::scoped_lock lock(mutex);
      if (!free.empty()) {
        auto drawing = std::move(free.back());
        free.pop_back();
        return drawing;
      }
    }
    return std::make_unique<SoftwareDrawing>(scene);
  }
  void give_back(std::unique_ptr<SoftwareDrawing> drawing, std::size_t triangles) {
    const std::scoped_lock lock(mutex);
    free.push_back(std::move(drawing));
    ++totals.views;
    totals.triangles += triangles;
  }

  mutable std::mutex mutex;
  std::vector<std::unique_ptr<SoftwareDrawing>> free;
  software::ShadowMaps shadows;
  std::unique_ptr<Stage> stage;
  DrawTotals totals;
};

SoftwareRenderer::SoftwareRenderer(const World& world, const std::vector<Entity*>& moving_entities,
                                   const AppearanceOf& appearance, const RendererOptions& options)
    : render_scene_(world, moving_entities, appearance), options_(options), drawings_(std::make_unique<Drawings>()) {
  set_light(options.light, options.samples);
}

SoftwareRenderer::~SoftwareRenderer() = default;

void SoftwareRenderer::set_light(const Light& light, int samples) {
  options_.light = light;
  options_.samples = samples;
  drawings_->stage = std::make_unique<Stage>(render_scene_, options_, drawings_->shadows);
}

DrawTotals SoftwareRenderer::totals() const {
  const std::scoped_lock lock(drawings_->mutex);
  return drawings_->totals;
}

void SoftwareRenderer::draw(const sensors::Perspective& perspective, const sensors::Layers& layers, double ahead,
                            sensors::View& view) noexcept {
  auto drawing = drawings_->take(render_scene_);
  const std::size_t triangles = drawing->draw(*drawings_->stage, perspective, layers, ahead, view);
  drawings_->give_back(std::move(drawing), triangles);
}

}  // namespace murosimf::render
