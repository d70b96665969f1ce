#include "murosimf/render/png.h"

#include <cstddef>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::render {

void refuse_picture(const std::string& reason) { throw SetupError(fmt::format("cannot draw the picture: {}", reason)); }

void check(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS) refuse_picture(cairo_status_to_string(status));
}

std::string png_of(cairo_surface_t* picture) {
  MUROSIMF_ASSERT(cairo_image_surface_get_format(picture) == CAIRO_FORMAT_RGB24);
  cairo_surface_flush(picture);
  const unsigned char* first = cairo_image_surface_get_data(picture);
  PngRows png{.width = cairo_image_surface_get_width(picture), .of_cairo = true};
  for (int v = 0; v < cairo_image_surface_get_height(picture); ++v) {
    png.rows.push_back(first + std::ptrdiff_t{v} * cairo_image_surface_get_stride(picture));
  }
  return encoded(png);
}

}  // namespace murosimf::render
