/// software_renderer.h - pictures of a scene by the processor alone: for robots' cameras, with the same bits on every machine.
///
/// It draws what Renderer draws of a perspective, by the same patterns and light, in less than half of the time that OpenGL takes on a
/// processor. It needs no driver.
#pragma once

#include <memory>
#include <vector>

#include "murosimf/render/light.h"
#include "murosimf/render/render_scene.h"
#include "murosimf/render/renderer.h"
#include "murosimf/sensors/view_source.h"

namespace murosimf::render {

class SoftwareRenderer final : public sensors::ViewSource {
 public:
  SoftwareRenderer(const World& world, const std::vector<Entity*>& moving_entities, const AppearanceOf& appearance,
                   const RendererOptions& options = {});
  ~SoftwareRenderer() override;

  void draw(const sensors::Perspective& perspective, const sensors::Layers& layers, double ahead,
            sensors::View& view) noexcept override;

  /// Takes effect with the next picture; not while a picture is drawn.
  void set_light(const Light& light, int samples);
  /// RenderScene::show: pictures show that moment, independent of the world.
  void show(const ShownMoment* moment) { render_scene_.show(moment); }
  [[nodiscard]] const RenderScene& scene() const { return render_scene_; }
  /// Must be called once when all algorithms are attached: from then on poses are current.
  void locate() { render_scene_.locate(); }
  [[nodiscard]] DrawTotals totals() const;

 private:
  struct Drawings;
  RenderScene render_scene_;
  RendererOptions options_;
  std::unique_ptr<Drawings> drawings_;
};

}  // namespace murosimf::render
