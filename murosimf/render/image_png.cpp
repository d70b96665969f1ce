#include "murosimf/render/image_png.h"

#include <algorithm>
#include <vector>

#include "murosimf/math/assert.h"
#include "murosimf/render/canvas.h"
#include "murosimf/render/png.h"
#include "murosimf/render/png_bytes.h"

namespace murosimf::render {
namespace {

void draw_title(cairo_surface_t* picture, int rows, const std::string& title) {
  const CanvasPtr canvas(cairo_create(picture), cairo_destroy);
  const double size = std::clamp(rows / 28.0, 11.0, 28.0);
  set_font(canvas.get(), size, true);
  cairo_rectangle(canvas.get(), 0.5 * size, 0.5 * size, text_width(canvas.get(), title) + size, 1.7 * size);
  set_color(canvas.get(), white, 0.75);
  cairo_fill(canvas.get());
  show_text(canvas.get(), size, 1.35 * size, title, {0.1, 0.12, 0.12});
  check(cairo_status(canvas.get()));
}

}  // namespace

std::string image_png(const imaging::ColorImage& image, const std::string& title) {
  if (title.empty()) return png_bytes(image);
  std::vector<std::uint32_t> pixels;
  pixels.reserve(image.pixels().size());
  for (const imaging::Rgb& p : image.pixels()) {
    pixels.push_back(static_cast<std::uint32_t>(p.red) << 16 | static_cast<std::uint32_t>(p.green) << 8 | p.blue);
  }
  MUROSIMF_ASSERT(pixels.size() == static_cast<std::size_t>(image.width()) * static_cast<std::size_t>(image.height()));
  const SurfacePtr surface(cairo_image_surface_create_for_data(reinterpret_cast<unsigned char*>(pixels.data()),
                                                               CAIRO_FORMAT_RGB24, image.width(), image.height(),
                                                               4 * image.width()),
                           cairo_surface_destroy);
  draw_title(surface.get(), image.height(), title);
  return png_of(surface.get());
}

}  // namespace murosimf::render
