/// png.h - rows of pixels, and a cairo picture, as the bytes of a PNG file.
///
/// Only for the .cpp files of this folder: it brings cairo in.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <cairo/cairo.h>

namespace murosimf::render {

using SurfacePtr = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using CanvasPtr = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

inline constexpr double largest_side = 16384;  ///< [pixels] cairo ends at 32767, and this takes a gigabyte

/// Throws SetupError: cannot draw the picture: reason.
[[noreturn]] void refuse_picture(const std::string& reason);
/// Throws SetupError if cairo reports an error.
void check(cairo_status_t status);

/// Rows from the top, as memory has them: 3 bytes a pixel in color, 1 or 2 in gray; cairo's CAIRO_FORMAT_RGB24 has 4.
struct PngRows {
  int width = 0;  ///< [pixels]
  int bits = 8;   ///< of a color or gray: 8 or 16
  bool colors = true;
  bool of_cairo = false;
  std::vector<const unsigned char*> rows = {};
};
/// Throws SetupError if libpng fails.
[[nodiscard]] std::string encoded(const PngRows& picture);
/// Of a picture of the format CAIRO_FORMAT_RGB24. Throws SetupError if libpng fails.
[[nodiscard]] std::string png_of(cairo_surface_t* picture);

}  // namespace murosimf::render
