#include "murosimf/render/field_picture.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include <fmt/format.h>

#include "murosimf/model/error.h"
#include "murosimf/render/field_drawing.h"
#include "murosimf/render/legend.h"
#include "murosimf/render/path_drawing.h"

namespace murosimf::render {
namespace {

using SurfacePtr = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using CanvasPtr = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

[[noreturn]] void refuse(const std::string& reason) {
  throw SetupError(fmt::format("cannot draw the picture: {}", reason));
}

void check(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS) refuse(cairo_status_to_string(status));
}

std::string encode(cairo_surface_t* picture) {
  std::string bytes;
  const auto append = [](void* to, const unsigned char* data, unsigned int size) {
    static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(data), size);
    return CAIRO_STATUS_SUCCESS;
  };
  check(cairo_surface_write_to_png_stream(picture, append, &bytes));
  return bytes;
}

Frame checked_frame(const Markings& markings, const FieldPictureOptions& options) {
  constexpr double largest = 16384;  // [pixels] cairo ends at 32767, and this is a gigabyte already
  const Frame frame = frame_of(markings, options.pixels_per_meter);
  const double longer = 2 * frame.scale * std::max(frame.half_length, frame.half_width);
  if (!(frame.half_length > 0 && frame.half_width > 0)) refuse("the markings have no half_length or half_width");
  if (frame.scale <= 0 || frame.columns() < 1 || frame.rows() < 1) refuse("pixels_per_meter is too small");
  if (!(longer <= largest)) refuse(fmt::format("pixels_per_meter is too large: over {} pixels", largest));
  return frame;
}

}  // namespace

std::string field_picture_png(const Markings& markings, const std::vector<Path>& paths,
                              const FieldPictureOptions& options) {
  const Frame frame = checked_frame(markings, options);
  const SurfacePtr picture(cairo_image_surface_create(CAIRO_FORMAT_RGB24, frame.columns(), frame.rows()),
                           cairo_surface_destroy);
  const CanvasPtr canvas(cairo_create(picture.get()), cairo_destroy);
  cairo_save(canvas.get());
  cairo_translate(canvas.get(), frame.columns() / 2.0, frame.rows() / 2.0);
  cairo_scale(canvas.get(), frame.scale, -frame.scale);
  draw_field(canvas.get(), markings, frame);
  draw_paths(canvas.get(), paths, frame);
  cairo_restore(canvas.get());
  draw_writing(canvas.get(), frame, paths, options.title);
  check(cairo_status(canvas.get()));
  return encode(picture.get());
}

}  // namespace murosimf::render
