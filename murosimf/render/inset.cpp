#include "murosimf/render/inset.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "murosimf/imaging/srgb.h"
#include "murosimf/math/assert.h"
#include "murosimf/render/seen_drawing.h"

namespace murosimf::render {
namespace {

using imaging::ColorImage;
using imaging::Rgb;

constexpr double largest = 0.34;           // [1] of the width and height of the picture
constexpr double frame_width = 1.0 / 240;  // [1] width of the frame, of the picture's height
constexpr double frame_margin = 1.0 / 45;  // [1] from the borders, of the picture's height
constexpr double name_height = 1.0 / 42;   // [1] height of the name, of the picture's height
constexpr Rgb frame_color{235, 235, 235};

/// Pixels from begin to end, one at least.
struct PixelRange {
  int begin = 0, end = 1;
};
PixelRange covered(int index, int of, int pixels) {
  MUROSIMF_ASSERT(of > 0 && pixels > 0);
  const auto at = [&](int i) { return static_cast<int>(std::int64_t{i} * pixels / of); };
  return {at(index), std::max(at(index) + 1, at(index + 1))};
}

Rgb mean_light(const ColorImage& picture, const PixelRange& columns, const PixelRange& rows) {
  const auto& light = imaging::light_table();
  std::uint64_t red = 0, green = 0, blue = 0;
  for (int v = rows.begin; v < rows.end; ++v) {
    for (int u = columns.begin; u < columns.end; ++u) {
      const Rgb& p = picture(u, v);
      red += light[p.red];
      green += light[p.green];
      blue += light[p.blue];
    }
  }
  const auto count = static_cast<std::uint64_t>(columns.end - columns.begin) * (rows.end - rows.begin);
  MUROSIMF_ASSERT(count > 0);
  const auto& value = imaging::value_table();
  return {value[red / count], value[green / count], value[blue / count]};
}

void fill(ColorImage& picture, int left, int top, int width, int height, const Rgb& color) {
  for (int v = std::max(0, top); v < std::min(picture.height(), top + height); ++v) {
    for (int u = std::max(0, left); u < std::min(picture.width(), left + width); ++u) picture(u, v) = color;
  }
}

}  // namespace

ColorImage scaled(const ColorImage& picture, int width, int height) {
  MUROSIMF_ASSERT(!picture.empty() && width > 0 && height > 0);
  ColorImage result(width, height);
  for (int v = 0; v < height; ++v) {
    const PixelRange rows = covered(v, height, picture.height());
    for (int u = 0; u < width; ++u) result(u, v) = mean_light(picture, covered(u, width, picture.width()), rows);
  }
  return result;
}

void draw_inset(ColorImage& picture, const ColorImage& inset, const std::string& name) {
  if (picture.empty() || inset.empty()) return;
  const double factor =
      std::min(largest * picture.width() / inset.width(), largest * picture.height() / inset.height());
  const int width = std::max(1, static_cast<int>(std::lround(factor * inset.width())));
  const int height = std::max(1, static_cast<int>(std::lround(factor * inset.height())));
  const int border = std::max(1, static_cast<int>(std::lround(frame_width * picture.height())));
  const int margin = border + static_cast<int>(std::lround(frame_margin * picture.height()));
  const int left = std::max(0, picture.width() - margin - width), top = std::max(0, picture.height() - margin - height);
  fill(picture, left - border, top - border, width + 2 * border, height + 2 * border, frame_color);
  const ColorImage small = scaled(inset, width, height);
  for (int v = 0; v < std::min(height, picture.height() - top); ++v) {
    for (int u = 0; u < std::min(width, picture.width() - left); ++u) picture(left + u, top + v) = small(u, v);
  }
  const double size = std::max(9.0, name_height * picture.height());
  const double half = 0.5 * width_of_words(name, size) + 0.25 * size;
  draw_over(picture, {SeenShape{.kind = SeenShape::Kind::words,
                                .points = {{left + half, top + 0.7 * size, 0}},
                                .size = size,
                                .color = {1, 1, 1},
                                .words = name}});
}

}  // namespace murosimf::render
