#include "murosimf/api/images.h"

#include <algorithm>

#include "murosimf/math/assert.h"

namespace murosimf::api {

Image image_of(const imaging::ColorImage& color, const imaging::GrayImage& mosaic, const imaging::DepthImage& depth,
               const imaging::LabelImage& labels) {
  Image image;
  image.width = std::max({color.width(), mosaic.width(), depth.width(), labels.width()});
  image.height = std::max({color.height(), mosaic.height(), depth.height(), labels.height()});
  image.rgb.reserve(3 * color.pixels().size());
  for (const imaging::Rgb& pixel : color.pixels()) {
    image.rgb.insert(image.rgb.end(), {pixel.red, pixel.green, pixel.blue});
  }
  image.mosaic.assign(mosaic.pixels().begin(), mosaic.pixels().end());
  image.depth.assign(depth.pixels().begin(), depth.pixels().end());
  image.labels.assign(labels.pixels().begin(), labels.pixels().end());
  MUROSIMF_ASSERT(image.rgb.empty() || image.rgb.size() == 3 * static_cast<std::size_t>(image.width) * image.height);
  return image;
}

}  // namespace murosimf::api
