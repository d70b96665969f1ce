/// png.h - a cairo picture as the bytes of a PNG file.
///
/// Only for the .cpp files of this folder: it brings cairo in.
#pragma once

#include <memory>
#include <string>

#include <cairo/cairo.h>

namespace murosimf::render {

using SurfacePtr = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using CanvasPtr = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

inline constexpr double largest_side = 16384;  ///< [pixels] cairo ends at 32767, and this takes a gigabyte

/// Throws SetupError: cannot draw the picture: reason.
[[noreturn]] void refuse_picture(const std::string& reason);
/// Throws SetupError if cairo reports an error.
void check(cairo_status_t status);
/// Throws SetupError if cairo fails.
[[nodiscard]] std::string png_of(cairo_surface_t* picture);

}  // namespace murosimf::render
