/// picture.h - a PNG file read back, and names for its colors.
///
/// Needs cairo.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include <cairo/cairo.h>

#include "murosimf/model/shape.h"

namespace murosimf::render {

/// A picture read back; colors 0..255.
class Picture {
 public:
  Picture(const std::filesystem::path& file, double scale = 1)
      : surface_(cairo_image_surface_create_from_png(file.c_str()), cairo_surface_destroy), scale_(scale) {}

  [[nodiscard]] int columns() const { return cairo_image_surface_get_width(surface_.get()); }
  [[nodiscard]] int rows() const { return cairo_image_surface_get_height(surface_.get()); }

  /// At a place on the ground [m].
  [[nodiscard]] Color at(double x, double y) const {
    return pixel(static_cast<int>(columns() / 2.0 + x * scale_), static_cast<int>(rows() / 2.0 - y * scale_));
  }
  [[nodiscard]] Color pixel(int column, int row) const {
    const unsigned char* data = cairo_image_surface_get_data(surface_.get());
    const int stride = cairo_image_surface_get_stride(surface_.get());
    const auto* line = reinterpret_cast<const std::uint32_t*>(data + row * stride);
    const std::uint32_t value = line[column];
    const auto channel = [value](int shift) { return static_cast<double>((value >> shift) & 0xff); };
    return {channel(16), channel(8), channel(0)};
  }

 private:
  std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface_;
  double scale_;
};

inline bool is_white(const Color& c) { return c.red > 230 && c.green > 230 && c.blue > 230; }
inline bool is_green(const Color& c) { return c.green > 1.5 * c.red && c.green > 1.5 * c.blue; }
inline bool is_reddish(const Color& c) { return c.red > 1.5 * c.green && c.red > 1.5 * c.blue; }
inline bool is_bluish(const Color& c) { return c.blue > 1.3 * c.green && c.blue > 1.5 * c.red; }

}  // namespace murosimf::render
