/// path_drawing.h - paths and places of robots and ball.
///
/// Only for the .cpp files of this folder: it brings cairo in.
#pragma once

#include <vector>

#include "murosimf/render/field_drawing.h"
#include "murosimf/render/field_picture.h"

namespace murosimf::render {

/// Draws them. The canvas is in meters, x to the right and y up, the middle of the field at the origin.
void draw_paths(cairo_t* canvas, const std::vector<Path>& paths, const PictureFrame& frame);

}  // namespace murosimf::render
