// Draws lines, areas and words for observers over a picture.
#include <cstdint>

#include "murosimf/math/assert.h"
#include "murosimf/render/canvas.h"
#include "murosimf/render/png.h"
#include "murosimf/render/seen_drawing.h"

namespace murosimf::render {
namespace {

void draw_words(cairo_t* canvas, const SeenShape& shape) {
  MUROSIMF_ASSERT(shape.points.size() == 1);
  set_font(canvas, shape.size, true);
  const double width = text_width(canvas, shape.words), x = shape.points[0].x - 0.5 * width, y = shape.points[0].y;
  const double margin = 0.25 * shape.size;
  cairo_rectangle(canvas, x - margin, y - 0.7 * shape.size, width + 2 * margin, 1.4 * shape.size);
  set_color(canvas, black, 0.45 * shape.opacity);
  cairo_fill(canvas);
  show_text(canvas, x, y, shape.words, shape.color);
}

void draw_seen(cairo_t* canvas, const SeenShape& shape) {
  if (shape.kind == SeenShape::Kind::words) return draw_words(canvas, shape);
  cairo_new_path(canvas);
  trace(canvas, shape.points);
  set_color(canvas, shape.color, shape.opacity);
  if (shape.kind == SeenShape::Kind::area) return cairo_fill(canvas);
  cairo_set_line_width(canvas, shape.size);
  cairo_stroke(canvas);
}

}  // namespace

double width_of_words(const std::string& words, double height) {
  const SurfacePtr surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, 1, 1), cairo_surface_destroy);
  check(cairo_surface_status(surface.get()));
  const CanvasPtr canvas(cairo_create(surface.get()), cairo_destroy);
  set_font(canvas.get(), height, true);
  const double width = text_width(canvas.get(), words);
  check(cairo_status(canvas.get()));
  return width;
}

void draw_over(imaging::ColorImage& picture, const std::vector<SeenShape>& shapes) {
  if (shapes.empty() || picture.empty()) return;
  // Cairo's rows are padded and its pixels are 32 bits wide: the picture is copied in and out.
  const SurfacePtr surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, picture.width(), picture.height()),
                           cairo_surface_destroy);
  check(cairo_surface_status(surface.get()));
  unsigned char* bytes = cairo_image_surface_get_data(surface.get());
  const int stride = cairo_image_surface_get_stride(surface.get());
  const auto pixel_at = [&](int u, int v) -> std::uint32_t& {
    MUROSIMF_ASSERT(u >= 0 && v >= 0 && 4 * u < stride);
    return reinterpret_cast<std::uint32_t*>(bytes + static_cast<std::ptrdiff_t>(v) * stride)[u];
  };
  cairo_surface_flush(surface.get());
  for (int v = 0; v < picture.height(); ++v) {
    for (int u = 0; u < picture.width(); ++u) {
      const imaging::Rgb& p = picture(u, v);
      pixel_at(u, v) = static_cast<std::uint32_t>(p.red) << 16 | static_cast<std::uint32_t>(p.green) << 8 | p.blue;
    }
  }
  cairo_surface_mark_dirty(surface.get());
  const CanvasPtr canvas(cairo_create(surface.get()), cairo_destroy);
  cairo_set_line_cap(canvas.get(), CAIRO_LINE_CAP_ROUND);
  for (const SeenShape& shape : shapes) draw_seen(canvas.get(), shape);
  check(cairo_status(canvas.get()));
  cairo_surface_flush(surface.get());
  for (int v = 0; v < picture.height(); ++v) {
    for (int u = 0; u < picture.width(); ++u) {
      const std::uint32_t p = pixel_at(u, v);
      picture(u, v) = {static_cast<std::uint8_t>(p >> 16), static_cast<std::uint8_t>(p >> 8),
                       static_cast<std::uint8_t>(p)};
    }
  }
}

}  // namespace murosimf::render
