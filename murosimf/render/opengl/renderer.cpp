#include "murosimf/render/renderer.h"
#include "murosimf/math/assert.h"

#include <mutex>

#include "murosimf/model/error.h"
#include "murosimf/render/opengl/gl_drawing.h"

namespace murosimf::render {

struct Renderer::Contexts {
  /// A context that no thread draws with, from the pool, or a new one.
  std::unique_ptr<GlDrawing> take(const RenderScene& render_scene) {
    // Contexts are made outside of the lock: that takes long.
    {
      const std::scoped_lock lock(mutex);
      if (!free.empty()) {
        auto drawing = std::move(free.back());
        free.pop_back();
        return drawing;
      }
    }
    return std::make_unique<GlDrawing>(render_scene);
  }
  void give_back(std::unique_ptr<GlDrawing> drawing, const DrawCount& drawn) {
    MUROSIMF_ASSERT(drawing != nullptr);
    const std::scoped_lock lock(mutex);
    free.push_back(std::move(drawing));
    ++totals.views;
    totals.drawables += drawn.drawables;
    totals.triangles += drawn.triangles;
  }
  /// Keeps the first error.
  void report(const char* what) {
    const std::scoped_lock lock(mutex);
    if (trouble.empty()) trouble = what;
  }

  mutable std::mutex mutex;
  std::vector<std::unique_ptr<GlDrawing>> free;
  DrawTotals totals;
  std::string trouble, name;
};

Renderer::Renderer(const World& world, const std::vector<Entity*>& moving_entities, const AppearanceOf& appearance,
                   RendererOptions options)
    : render_scene_(world, moving_entities, appearance), options_(options), contexts_(std::make_unique<Contexts>()) {
  auto drawing = contexts_->take(render_scene_);
  const GlContext& context = drawing->context();
  contexts_->name = context.renderer() + (context.software() ? ", software" : "");
  contexts_->free.push_back(std::move(drawing));
}

Renderer::~Renderer() = default;

void Renderer::locate() { render_scene_.locate(); }
std::string Renderer::name() const { return contexts_->name; }

DrawTotals Renderer::totals() const {
  const std::scoped_lock lock(contexts_->mutex);
  return contexts_->totals;
}

std::string Renderer::trouble() const {
  const std::scoped_lock lock(contexts_->mutex);
  return contexts_->trouble;
}

void Renderer::draw(const sensors::Perspective& perspective, const sensors::Layers& layers, double ahead,
                    sensors::View& view) noexcept {
  draw_projection(perspective, layers, ahead, view);
}

void Renderer::draw(const ParallelView& view, const sensors::Layers& layers, double ahead,
                    sensors::View& into) noexcept {
  draw_projection(view, layers, ahead, into);
}

void Renderer::draw_projection(const Projection& projection, const sensors::Layers& layers, double ahead,
                               sensors::View& view) noexcept {
  try {
    auto drawing = contexts_->take(render_scene_);
    const DrawCount drawn = drawing->draw(projection, layers, options_, ahead, view);
    contexts_->give_back(std::move(drawing), drawn);
  } catch (const std::exception& error) {
    contexts_->report(error.what());
  }
}

}  // namespace murosimf::render
