/// overlay_drawing.h - arrows, circles and lines over a field.
///
/// Only for the .cpp files of this folder: it brings cairo in.
#pragma once

#include "murosimf/render/field_drawing.h"
#include "murosimf/render/overlay.h"

namespace murosimf::render {

/// Draws lines, then circles, then arrows; those that are not finite are left out. The canvas is in meters, x to the right and y up, the
/// middle of the field at the origin.
void draw_overlay(cairo_t* canvas, const Overlay& overlay, const PictureFrame& frame);

}  // namespace murosimf::render
