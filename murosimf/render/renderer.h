/// renderer.h - pictures of a scene, for observers and for cameras.
///
/// Two renderers draw the same by the same light and patterns: one by the processor alone (software_renderer.h), with the same bits on every
/// machine, and one by OpenGL (opengl_renderer.h), for graphics cards.
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

/// What one view has drawn.
struct DrawCount {
  std::size_t drawables = 0, triangles = 0;
};

struct RendererOptions {
  Light light{};
  int samples = 1;         ///< to a pixel, of colors: 1, 2, 4 or 8; edges are smooth with 4
  bool fine = false;       ///< soft shadows, and pile of short fibers: for people
  bool ground = true;      ///< draws the ground, at z = 0
  int shadow_side = 2048;  ///< [px] of the square shadow map
  int light_number = 0;    ///< another one with every new light
  int threads = 1;         ///< that draw a picture together where the processor draws: the same bits for any number
};

class Renderer : public sensors::ViewSource {
 public:
  Renderer(const World& world, const std::vector<Entity*>& moving_entities, const AppearanceOf& appearance,
           const RendererOptions& options)
      : render_scene_(world, moving_entities, appearance), options_(options) {}

  /// Throws no error: trouble() has it.
  void draw(const sensors::Perspective& perspective, const sensors::Layers& layers, double ahead,
            sensors::View& view) noexcept override {
    draw_projection(perspective, layers, ahead, view);
  }
  /// The same by parallel rays. A level view shows the ground cut open.
  void draw(const ParallelView& view, const sensors::Layers& layers, double ahead, sensors::View& into) noexcept {
    draw_projection(view, layers, ahead, into);
  }

  /// Takes effect with the next picture; not while a picture is drawn.
  void set_light(const Light& light, int samples) {
    options_.light = light;
    options_.samples = samples;
    ++options_.light_number;
    options_changed();
  }
  /// The same; before the first picture. Coarser shadows cost less where the processor draws.
  void set_shadow_side(int side) {
    options_.shadow_side = side;
    options_changed();
  }
  /// RenderScene::mark_standing_feet; before the first picture.
  void mark_standing_feet(const Color& color) { render_scene_.mark_standing_feet(color); }
  /// RenderScene::show: pictures show that moment, independent of the world.
  void show(const ShownMoment* moment) { render_scene_.show(moment); }
  /// RenderScene::label_pieces; before the first picture.
  void label_pieces() { render_scene_.label_pieces(); }
  [[nodiscard]] const RenderScene& scene() const { return render_scene_; }
  /// Must be called once when all algorithms are attached: from then on poses are current.
  void locate() { render_scene_.locate(); }

  /// What draws: the name of a graphics card, "llvmpipe (LLVM 15.0.6, 256 bits), software" or "own rasterizer, software".
  [[nodiscard]] virtual std::string name() const = 0;
  /// Whether no graphics card draws.
  [[nodiscard]] virtual bool on_processor() const = 0;
  [[nodiscard]] virtual DrawTotals totals() const = 0;
  /// First error of the device; empty if there was none.
  [[nodiscard]] virtual std::string trouble() const = 0;

 protected:
  [[nodiscard]] const RendererOptions& options() const { return options_; }

 private:
  virtual void draw_projection(const Projection& projection, const sensors::Layers& layers, double ahead,
                               sensors::View& view) noexcept = 0;
  virtual void options_changed() {}

  RenderScene render_scene_;
  RendererOptions options_;
};

/// For observers: by a graphics card if OpenGL finds one, otherwise by the processor alone. The environment variable
/// MUROSIMF_RENDERER chooses, too: "opengl" or "software". Throws SetupError if what it names cannot draw here.
[[nodiscard]] std::unique_ptr<Renderer> make_renderer(const World& world, const std::vector<Entity*>& moving_entities,
                                                      const AppearanceOf& appearance, const RendererOptions& options);

}  // namespace murosimf::render
