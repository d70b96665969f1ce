#include <vector>

#include <fmt/format.h>
#include <png.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/render/picture_reading.h"

namespace murosimf::render {
namespace {

/// libpng's own reader, which reports errors without jumps.
class Reading {
 public:
  explicit Reading(const std::string& bytes) {
    picture.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_memory(&picture, bytes.data(), bytes.size()) == 0) fail();
  }
  ~Reading() { png_image_free(&picture); }
  Reading(const Reading&) = delete;
  Reading& operator=(const Reading&) = delete;

  [[noreturn]] void fail() const { throw SetupError(fmt::format("the picture cannot be read: {}", picture.message)); }

  png_image picture{};
};

}  // namespace

imaging::ColorImage picture_of_png(const std::string& bytes) {
  Reading reading(bytes);
  png_image& picture = reading.picture;
  check_picture_size(picture.width, picture.height);
  picture.format = PNG_FORMAT_RGBA;
  std::vector<std::uint8_t> rgba(PNG_IMAGE_SIZE(picture));
  if (png_image_finish_read(&picture, nullptr, rgba.data(), 0, nullptr) == 0) reading.fail();
  imaging::ColorImage image(static_cast<int>(picture.width), static_cast<int>(picture.height));
  MUROSIMF_ASSERT(rgba.size() == 4 * image.pixels().size());
  std::size_t i = 0;
  for (imaging::Rgb& pixel : image.pixels()) {
    pixel = {rgba[i], rgba[i + 1], rgba[i + 2]};
    i += 4;
  }
  return image;
}

}  // namespace murosimf::render
