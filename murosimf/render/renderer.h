/// renderer.h - pictures of a scene by OpenGL, for cameras and for people. No window system is ever asked for.
///
/// Drawing is by EGL on a graphics card, or by the processor (Mesa's llvmpipe) where there is none.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "murosimf/render/light.h"
#include "murosimf/render/projection.h"
#include "murosimf/render/render_scene.h"
#include "murosimf/sensors/view_source.h"

namespace murosimf::render {

/// How much was drawn so far, by all views of a renderer.
struct DrawTotals {
  std::size_t views = 0, drawables = 0, triangles = 0;
};

struct RendererOptions {
  Light light{};
  int samples = 1;         ///< to a pixel, of colors: 1, 2, 4 or 8; edges are smooth with 4
  bool ground = true;      ///< is drawn, at z = 0
  int shadow_side = 2048;  ///< [px] of the square in which shadows are worked out
};

class Renderer final : public sensors::ViewSource {
 public:
  /// Throws SetupError if this machine or this build cannot draw, and what to install.
  Renderer(const World& world, const std::vector<Entity*>& moving_entities, const AppearanceOf& appearance,
           RendererOptions options = {});
  ~Renderer() override;

  void draw(const sensors::Perspective& perspective, const sensors::Layers& layers, double ahead,
            sensors::View& view) noexcept override;
  /// The same by parallel rays. Who looks level sees the ground cut open.
  void draw(const ParallelView& view, const sensors::Layers& layers, double ahead, sensors::View& into) noexcept;

  /// From the next picture on; while nothing draws.
  void set_light(const Light& light, int samples) {
    options_.light = light;
    options_.samples = samples;
  }
  /// The same; before it draws. Coarser shadows cost less where the processor draws.
  void set_shadow_side(int side) { options_.shadow_side = side; }
  /// RenderScene::mark_standing_feet; before it draws.
  void mark_standing_feet(const Color& color) { render_scene_.mark_standing_feet(color); }

  /// RenderScene::show: pictures are of that moment from now on, and nothing of the world changes them.
  void show(const ShownMoment* moment) { render_scene_.show(moment); }
  /// RenderScene::label_pieces; before it draws.
  void label_pieces() { render_scene_.label_pieces(); }
  [[nodiscard]] const RenderScene& scene() const { return render_scene_; }

  /// To be called once when all algorithms are attached: from then on things are seen where they are.
  void locate();

  /// "llvmpipe (LLVM 15.0.6, 256 bits), software" or the name of a graphics card.
  [[nodiscard]] std::string name() const;
  [[nodiscard]] DrawTotals totals() const;
  /// What the device could not do, once; empty if all is well.
  [[nodiscard]] std::string trouble() const;

 private:
  struct Contexts;  // one for each thread that draws at the same time
  void draw_projection(const Projection& projection, const sensors::Layers& layers, double ahead,
                       sensors::View& view) noexcept;

  RenderScene render_scene_;
  RendererOptions options_;
  std::unique_ptr<Contexts> contexts_;
};

}  // namespace murosimf::render
