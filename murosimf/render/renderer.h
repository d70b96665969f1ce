/// renderer.h - pictures of a scene by OpenGL, for cameras and for observers, without any window system.
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

/// Amount of what all views of a renderer have drawn so far.
struct DrawTotals {
  std::size_t views = 0, drawables = 0, triangles = 0;
};

struct RendererOptions {
  Light light{};
  int samples = 1;         ///< to a pixel, of colors: 1, 2, 4 or 8; edges are smooth with 4
  bool ground = true;      ///< draws the ground, at z = 0
  int shadow_side = 2048;  ///< [px] of the square shadow map
  int light_number = 0;    ///< another one with every new light
};

class Renderer final : public sensors::ViewSource {
 public:
  /// Throws SetupError if this machine or this build cannot draw, with what to install.
  Renderer(const World& world, const std::vector<Entity*>& moving_entities, const AppearanceOf& appearance,
           RendererOptions options = {});
  ~Renderer() override;

  void draw(const sensors::Perspective& perspective, const sensors::Layers& layers, double ahead,
            sensors::View& view) noexcept override;
  /// The same by parallel rays. A level view shows the ground cut open.
  void draw(const ParallelView& view, const sensors::Layers& layers, double ahead, sensors::View& into) noexcept;

  /// Takes effect with the next picture; not while a picture is drawn.
  void set_light(const Light& light, int samples) {
    options_.light = light;
    options_.samples = samples;
    ++options_.light_number;
  }
  /// The same; before the first picture. Coarser shadows cost less where the processor draws.
  void set_shadow_side(int side) { options_.shadow_side = side; }
  /// RenderScene::mark_standing_feet; before the first picture.
  void mark_standing_feet(const Color& color) { render_scene_.mark_standing_feet(color); }

  /// RenderScene::show: pictures show that moment, independent of the world.
  void show(const ShownMoment* moment) { render_scene_.show(moment); }
  /// RenderScene::label_pieces; before the first picture.
  void label_pieces() { render_scene_.label_pieces(); }
  [[nodiscard]] const RenderScene& scene() const { return render_scene_; }

  /// Must be called once when all algorithms are attached: from then on poses are current.
  void locate();

  /// "llvmpipe (LLVM 15.0.6, 256 bits), software" or the name of a graphics card.
  [[nodiscard]] std::string name() const;
  [[nodiscard]] DrawTotals totals() const;
  /// First error of the device; empty if there was none.
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
