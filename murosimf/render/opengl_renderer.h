/// opengl_renderer.h - pictures of a scene by OpenGL, without any window system.
///
/// Drawing is by EGL on a graphics card, or by the processor (Mesa's llvmpipe) where there is none.
#pragma once

#include "murosimf/render/renderer.h"

namespace murosimf::render {

/// Whether OpenGL finds a graphics card here. Takes some time when it is asked first.
[[nodiscard]] bool has_graphics_card();

class OpenGlRenderer final : public Renderer {
 public:
  /// Throws SetupError if this machine or this build has no OpenGL, with what to install.
  OpenGlRenderer(const World& world, const std::vector<Entity*>& moving_entities, const AppearanceOf& appearance,
                 const RendererOptions& options = {});
  ~OpenGlRenderer() override;

  [[nodiscard]] std::string name() const override;
  [[nodiscard]] bool on_processor() const override;
  [[nodiscard]] DrawTotals totals() const override;
  [[nodiscard]] std::string trouble() const override;

 private:
  struct Contexts;  // one for each thread that draws at the same time
  void draw_projection(const Projection& projection, const sensors::Layers& layers, double ahead,
                       sensors::View& view) noexcept override;

  std::unique_ptr<Contexts> contexts_;
};

}  // namespace murosimf::render
