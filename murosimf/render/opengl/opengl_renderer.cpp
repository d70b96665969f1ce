#include "murosimf/render/opengl_renderer.h"

#include <exception>

#include "murosimf/render/drawing_pool.h"
#include "murosimf/render/opengl/gl_drawing.h"

namespace murosimf::render {

bool has_graphics_card() {
  static const bool found = finds_graphics_card();
  return found;
}

struct OpenGlRenderer::Contexts {
  /// Keeps the first error.
  void report(const char* what) {
    const std::scoped_lock lock(mutex);
    if (trouble.empty()) trouble = what;
  }

  DrawingPool<GlDrawing> pool;
  mutable std::mutex mutex;  // of trouble
  std::string trouble, name;
  bool on_processor = false;
};

OpenGlRenderer::OpenGlRenderer(const World& world, const std::vector<Entity*>& moving_entities,
                               const AppearanceOf& appearance, const RendererOptions& options)
    : Renderer(world, moving_entities, appearance, options), contexts_(std::make_unique<Contexts>()) {
  auto drawing = std::make_unique<GlDrawing>(scene());
  contexts_->on_processor = drawing->context().software();
  contexts_->name = drawing->context().renderer() + (contexts_->on_processor ? ", software" : "");
  contexts_->pool.add(std::move(drawing));
}

OpenGlRenderer::~OpenGlRenderer() = default;

std::string OpenGlRenderer::name() const { return contexts_->name; }
bool OpenGlRenderer::on_processor() const { return contexts_->on_processor; }
DrawTotals OpenGlRenderer::totals() const { return contexts_->pool.totals(); }

std::string OpenGlRenderer::trouble() const {
  const std::scoped_lock lock(contexts_->mutex);
  return contexts_->trouble;
}

void OpenGlRenderer::draw_projection(const Projection& projection, const sensors::Layers& layers, double ahead,
                                     sensors::View& view) noexcept {
  try {
    auto drawing = contexts_->pool.take(scene());
    const DrawCount drawn = drawing->draw(projection, layers, options(), ahead, view);
    contexts_->pool.give_back(std::move(drawing), drawn);
  } catch (const std::exception& error) {
    contexts_->report(error.what());
  }
}

}  // namespace murosimf::render
