/// field_drawing.h - the ground of a picture from above: grass, lines, goals.
///
/// Only for the .cpp files of this folder: it brings cairo in.
#pragma once

#include <cmath>

#include "murosimf/render/canvas.h"

namespace murosimf::render {

/// Area and scale of a picture.
struct PictureFrame {
  double half_length = 0, half_width = 0;                   // [m] of the picture
  double lines_length = 0, lines_width = 0;                 // [m] half, of the area inside the outer lines
  double scale = 0;                                         // [pixels/m]
  [[nodiscard]] double pixel() const { return 1 / scale; }  // [m]
  [[nodiscard]] int columns() const { return static_cast<int>(std::lround(2 * half_length * scale)); }
  [[nodiscard]] int rows() const { return static_cast<int>(std::lround(2 * half_width * scale)); }
};

/// The frame of the markings; lines_length and lines_width are zero without a closed stroke.
[[nodiscard]] PictureFrame frame_of(const Markings& markings, double pixels_per_meter);

/// Draws the field. The canvas is in meters, x to the right and y up, the middle of the field at the origin.
void draw_field(cairo_t* canvas, const Markings& markings, const PictureFrame& frame);

}  // namespace murosimf::render
