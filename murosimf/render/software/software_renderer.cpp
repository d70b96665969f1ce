#include "murosimf/render/software_renderer.h"

#include <algorithm>
#include <thread>
#include <vector>

#include "murosimf/render/drawing_pool.h"
#include "murosimf/render/software/software_drawing.h"

namespace murosimf::render {
namespace {

constexpr int least_rows = 64;  // of a band: what is drawn is transformed for each of them
constexpr std::size_t most_pixels = std::size_t{1}
                                    << 24U;  // of a picture in bands: each has a buffer for several samples to a pixel

/// Parts of a picture, of some rows each.
std::vector<Projection> bands_of(const Projection& all, int count) {
  const sensors::Perspective& window = all.window;
  const int rows = window.rows == 0 ? window.height - window.first_row : window.rows;
  const bool is_large = static_cast<std::size_t>(window.width) * static_cast<std::size_t>(rows) > most_pixels;
  count = is_large ? 1 : std::clamp(rows / least_rows, 1, std::max(count, 1));
  std::vector<Projection> bands;
  for (int i = 0; i < count; ++i) {
    sensors::Perspective& band = bands.emplace_back(all).window;
    band.first_row = window.first_row + i * rows / count;
    band.rows = window.first_row + (i + 1) * rows / count - band.first_row;
  }
  return bands;
}

void fit(sensors::View& view, const sensors::Layers& layers, const sensors::Perspective& window) {
  if (layers.color) imaging::fit(view.color, window.width, window.height);
  if (layers.depth) imaging::fit(view.depth, window.width, window.height);
  if (layers.labels) imaging::fit(view.labels, window.width, window.height);
}

}  // namespace

using software::SoftwareDrawing;
using software::Stage;

struct SoftwareRenderer::Drawings {
  DrawingPool<SoftwareDrawing> pool;
  software::ShadowMaps shadows;
  std::unique_ptr<Stage> stage;
};

SoftwareRenderer::SoftwareRenderer(const World& world, const std::vector<Entity*>& moving_entities,
                                   const AppearanceOf& appearance, const RendererOptions& options)
    : Renderer(world, moving_entities, appearance, options), drawings_(std::make_unique<Drawings>()) {
  options_changed();
}

SoftwareRenderer::~SoftwareRenderer() = default;

void SoftwareRenderer::options_changed() {
  drawings_->stage = std::make_unique<Stage>(scene(), options(), drawings_->shadows);
}

DrawTotals SoftwareRenderer::totals() const { return drawings_->pool.totals(); }

void SoftwareRenderer::draw_projection(const Projection& projection, const sensors::Layers& layers, double ahead,
                                       sensors::View& view) noexcept {
  const auto draw = [&](const Projection& part) {
    auto drawing = drawings_->pool.take(scene());
    const DrawCount drawn = drawing->draw(*drawings_->stage, part, layers, ahead, view);
    drawings_->pool.give_back(std::move(drawing), drawn);
  };
  const std::vector<Projection> bands = bands_of(projection, options().threads);
  fit(view, layers, projection.window);
  std::vector<std::jthread> others;
  for (std::size_t i = 1; i < bands.size(); ++i) others.emplace_back(draw, bands[i]);
  draw(bands[0]);
}

}  // namespace murosimf::render
