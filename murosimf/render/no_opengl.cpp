// Replaces the renderer by OpenGL where that is missing.
#include "murosimf/model/error.h"
#include "murosimf/render/opengl_renderer.h"

namespace murosimf::render {

bool has_graphics_card() { return false; }

struct OpenGlRenderer::Contexts {};

OpenGlRenderer::OpenGlRenderer(const World& world, const std::vector<Entity*>& moving_entities,
                               const AppearanceOf& appearance, const RendererOptions& options)
    : Renderer(world, moving_entities, appearance, options) {
  throw SetupError(
      "no pictures by OpenGL in this build: epoxy or EGL was missing (Debian and Ubuntu: libepoxy-dev, libegl-dev)");
}

OpenGlRenderer::~OpenGlRenderer() = default;
void OpenGlRenderer::draw_projection(const Projection& /*projection*/, const sensors::Layers& /*layers*/,
                                     double /*ahead*/, sensors::View& /*view*/) noexcept {}
std::string OpenGlRenderer::name() const { return {}; }
bool OpenGlRenderer::on_processor() const { return false; }
DrawTotals OpenGlRenderer::totals() const { return {}; }
std::string OpenGlRenderer::trouble() const { return {}; }

}  // namespace murosimf::render
