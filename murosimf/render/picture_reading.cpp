#include "murosimf/render/picture_reading.h"

#include <fmt/format.h>

#include "murosimf/model/error.h"

namespace murosimf::render {

void check_picture_size(std::int64_t width, std::int64_t height) {
  // Each number alone first: their product must not overflow.
  if (width <= most_read_pixels && height <= most_read_pixels && width * height <= most_read_pixels) return;
  throw SetupError(fmt::format("the picture has {} x {} pixels, at most {} in all are read; make it smaller", width,
                               height, most_read_pixels));
}

imaging::ColorImage picture_of_file(const std::string& bytes) {
  return bytes.starts_with("\xff\xd8") ? picture_of_jpeg(bytes) : picture_of_png(bytes);
}

}  // namespace murosimf::render
