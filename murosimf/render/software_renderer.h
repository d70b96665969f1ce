/// software_renderer.h - pictures of a scene by the processor alone, with the same bits on every machine.
///
/// It draws what OpenGL draws, by the same patterns and light, in less than half of the time that OpenGL takes on a processor. It needs no
/// driver.
#pragma once

#include "murosimf/render/renderer.h"

namespace murosimf::render {

class SoftwareRenderer final : public Renderer {
 public:
  SoftwareRenderer(const World& world, const std::vector<Entity*>& moving_entities, const AppearanceOf& appearance,
                   const RendererOptions& options = {});
  ~SoftwareRenderer() override;

  [[nodiscard]] std::string name() const override { return "own rasterizer, software"; }
  [[nodiscard]] bool on_processor() const override { return true; }
  [[nodiscard]] DrawTotals totals() const override;
  [[nodiscard]] std::string trouble() const override { return {}; }

 private:
  struct Drawings;
  void draw_projection(const Projection& projection, const sensors::Layers& layers, double ahead,
                       sensors::View& view) noexcept override;
  void options_changed() override;

  std::unique_ptr<Drawings> drawings_;
};

}  // namespace murosimf::render
