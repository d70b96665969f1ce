#include "murosimf/render/png.h"

#include <fmt/format.h>

#include "murosimf/model/error.h"

namespace murosimf::render {

void refuse_picture(const std::string& reason) { throw SetupError(fmt::format("cannot draw the picture: {}", reason)); }

void check(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS) refuse_picture(cairo_status_to_string(status));
}

std::string png_of(cairo_surface_t* picture) {
  std::string bytes;
  const auto append = [](void* to, const unsigned char* data, unsigned int size) {
    static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(data), size);
    return CAIRO_STATUS_SUCCESS;
  };
  check(cairo_surface_write_to_png_stream(picture, append, &bytes));
  return bytes;
}

}  // namespace murosimf::render
