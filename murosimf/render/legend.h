/// legend.h - title and legend in the border strip of a picture.
///
/// Only for the .cpp files of this folder: it brings cairo in.
#pragma once

#include <string>
#include <vector>

#include "murosimf/render/field_drawing.h"
#include "murosimf/render/field_picture.h"

namespace murosimf::render {

/// Draws title and legend. The canvas is in pixels, y down.
void draw_writing(cairo_t* canvas, const PictureFrame& frame, const std::vector<Path>& paths, const std::string& title);

}  // namespace murosimf::render
