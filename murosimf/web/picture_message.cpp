#include "murosimf/web/picture_message.h"

#include <algorithm>
#include <cmath>

#include "murosimf/math/assert.h"
#include "murosimf/web/little_endian.h"
#include "murosimf/web/pose_message.h"

namespace murosimf::web {
namespace {

/// `put` appends the three colors of a pixel.
template <class Image, class Put>
std::string message_of(const Image& image, const Put& put) {
  MUROSIMF_ASSERT(image.width() > 0 && image.height() > 0);
  const int step = (std::max(image.width(), image.height()) + most_pixels - 1) / most_pixels;
  const int width = image.width() / step, height = image.height() / step;
  std::string out;
  out.reserve(static_cast<std::size_t>(8 + 3 * width * height));
  put_u8(out, static_cast<std::uint8_t>(MessageKind::picture));
  put_u8(out, 0);
  put_u16(out, static_cast<std::uint16_t>(width));
  put_u16(out, static_cast<std::uint16_t>(height));
  put_u16(out, 0);
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) put(out, image(step * u, step * v));
  }
  MUROSIMF_ASSERT(out.size() == 8 + 3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  return out;
}

void put_gray(std::string& out, std::uint8_t brightness) { out.append(3, static_cast<char>(brightness)); }

/// Half brightness at twice the distance; 0.2 m is white.
std::uint8_t brightness_of(float depth) {
  constexpr double white = 0.2;  // [m]
  return std::isfinite(depth) && depth > 0
             ? static_cast<std::uint8_t>(std::lround(255 * std::clamp(white / static_cast<double>(depth), 0.0, 1.0)))
             : std::uint8_t{0};
}

}  // namespace

std::string picture_message(const sensors::CameraFrame& frame) {
  if (!frame.color.empty()) {
    return message_of(frame.color, [](std::string& out, const imaging::Rgb& color) {
      for (const std::uint8_t part : {color.red, color.green, color.blue}) put_u8(out, part);
    });
  }
  if (!frame.mosaic.empty()) return message_of(frame.mosaic, put_gray);
  if (frame.depth.empty()) return {};
  return message_of(frame.depth, [](std::string& out, float depth) { put_gray(out, brightness_of(depth)); });
}

}  // namespace murosimf::web
