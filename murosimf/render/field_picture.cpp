#include "murosimf/render/field_picture.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/render/field_drawing.h"
#include "murosimf/render/legend.h"
#include "murosimf/render/overlay_drawing.h"
#include "murosimf/render/path_drawing.h"
#include "murosimf/render/png.h"

namespace murosimf::render {
namespace {

PictureFrame checked_frame(const Markings& markings, const FieldPictureOptions& options) {
  const PictureFrame frame = frame_of(markings, options.pixels_per_meter);
  const double longer = 2 * frame.scale * std::max(frame.half_length, frame.half_width);
  if (!(frame.half_length > 0 && frame.half_width > 0))
    refuse_picture("the markings have no half_length or half_width");
  if (frame.scale <= 0 || frame.columns() < 1 || frame.rows() < 1) refuse_picture("pixels_per_meter is too small");
  if (!(longer <= largest_side))
    refuse_picture(fmt::format("pixels_per_meter is too large: over {} pixels", largest_side));
  MUROSIMF_ASSERT(frame.columns() >= 1 && frame.rows() >= 1);
  return frame;
}

}  // namespace

std::string field_picture_png(const Markings& markings, const std::vector<Path>& paths,
                              const FieldPictureOptions& options) {
  const PictureFrame frame = checked_frame(markings, options);
  const SurfacePtr picture(cairo_image_surface_create(CAIRO_FORMAT_RGB24, frame.columns(), frame.rows()),
                           cairo_surface_destroy);
  const CanvasPtr canvas(cairo_create(picture.get()), cairo_destroy);
  cairo_save(canvas.get());
  cairo_translate(canvas.get(), frame.columns() / 2.0, frame.rows() / 2.0);
  cairo_scale(canvas.get(), frame.scale, -frame.scale);  // y of the field goes up, that of the picture down
  draw_field(canvas.get(), markings, frame);
  draw_paths(canvas.get(), paths, frame);
  draw_overlay(canvas.get(), options.overlay, frame);
  cairo_restore(canvas.get());
  draw_writing(canvas.get(), frame, paths, options.title);
  check(cairo_status(canvas.get()));
  return png_of(picture.get());
}

}  // namespace murosimf::render
