// Replaces the renderer where OpenGL is missing.
#include "murosimf/model/error.h"
#include "murosimf/render/renderer.h"

namespace murosimf::render {

struct Renderer::Contexts {};

Renderer::Renderer(const World& world, const std::vector<Entity*>& moving_entities, const AppearanceOf& appearance,
                   RendererOptions /*options*/)
    : render_scene_(world, moving_entities, appearance) {
  throw SetupError(
      "no pictures by OpenGL in this build: epoxy or EGL was missing (Debian and Ubuntu: libepoxy-dev, libegl-dev)");
}

Renderer::~Renderer() = default;
void Renderer::locate() {}
void Renderer::draw(const sensors::Perspective& /*perspective*/, const sensors::Layers& /*layers*/, double /*ahead*/,
                    sensors::View& /*view*/) noexcept {}
void Renderer::draw(const ParallelView& /*view*/, const sensors::Layers& /*layers*/, double /*ahead*/,
                    sensors::View& /*into*/) noexcept {}
std::string Renderer::name() const { return {}; }
DrawTotals Renderer::totals() const { return {}; }
std::string Renderer::trouble() const { return {}; }

}  // namespace murosimf::render
