#include "murosimf/render/image_png.h"

#include <vector>

#include "murosimf/render/png.h"

namespace murosimf::render {

std::string image_png(const imaging::ColorImage& image) {
  std::vector<std::uint32_t> pixels;
  pixels.reserve(image.pixels().size());
  for (const imaging::Rgb& p : image.pixels()) {
    pixels.push_back(static_cast<std::uint32_t>(p.red) << 16 | static_cast<std::uint32_t>(p.green) << 8 | p.blue);
  }
  const SurfacePtr surface(cairo_image_surface_create_for_data(reinterpret_cast<unsigned char*>(pixels.data()),
                                                               CAIRO_FORMAT_RGB24, image.width(), image.height(),
                                                               4 * image.width()),
                           cairo_surface_destroy);
  return png_of(surface.get());
}

}  // namespace murosimf::render
