#include "murosimf/render/software/picture_light.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "murosimf/imaging/srgb.h"

namespace murosimf::render::software {
namespace {

using imaging::ColorImage;

const std::array<float, 256> light_of = [] {
  std::array<float, 256> made{};
  for (std::size_t i = 0; i < made.size(); ++i)
    made[i] = static_cast<float>(imaging::light_of_srgb(static_cast<double>(i) / 255));
  return made;
}();

/// Binary logarithm of a positive finite number, to 0.01; the same bits on every machine.
float log2_of(float x) {
  const auto bits = std::bit_cast<std::uint32_t>(x);
  const auto exponent = static_cast<int>(bits >> 23U & 0xffU) - 127;
  const float m = std::bit_cast<float>((bits & 0x007fffffU) | 0x3f800000U);  // 1 to 2
  return static_cast<float>(exponent) + (m * (2 - m * (1.0F / 3)) - 5.0F / 3);
}

/// A place along a side, which repeats: two neighboring pixels and the share of the second.
struct Between {
  Between(float place, int size) {
    const float within = std::isfinite(place) ? place - std::floor(place) : 0;
    const float x = within * static_cast<float>(size) - 0.5F, low = std::floor(x);
    share = x - low;
    first = static_cast<int>(low);
    second = first + 1 >= size ? 0 : first + 1;
    if (first < 0) first = size - 1;
    first = std::min(first, size - 1);
  }
  int first, second;
  float share;
};

Float3 mixed(const Float3& a, const Float3& b, float t) {
  return {a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t, a.z + (b.z - a.z) * t};
}

Float3 light_at(const ColorImage& picture, float right, float down) {
  const Between u(right, picture.width()), v(down, picture.height());
  const auto pixel = [&](int x, int y) {
    const imaging::Rgb& p = picture(x, y);
    return Float3{light_of[p.red], light_of[p.green], light_of[p.blue]};
  };
  return mixed(mixed(pixel(u.first, v.first), pixel(u.second, v.first), u.share),
               mixed(pixel(u.first, v.second), pixel(u.second, v.second), u.share), v.share);
}

/// `square`: [px^2] of the whole picture, the longest step from pixel to pixel.
Float3 light_at(const imaging::MipPicture& picture, float square, float right, float down) {
  const auto last = static_cast<int>(picture.levels.size()) - 1;
  const float level = square > 1 ? std::min(0.5F * log2_of(square), static_cast<float>(last)) : 0;
  const auto first = static_cast<std::size_t>(level);
  const Float3 light = light_at(picture.levels[first], right, down);
  const float share = level - static_cast<float>(first);
  return share > 0 ? mixed(light, light_at(picture.levels[first + 1], right, down), share) : light;
}

}  // namespace

Floats3 picture_light(const PicturePoints& points) {
  Floats3 result{Floats{} + 1.0F, Floats{} + 1.0F, Floats{} + 1.0F};
  for (int i = 0; i < pixel_lanes; ++i) {
    const imaging::MipPicture* picture = points.pictures[static_cast<std::size_t>(i)];
    if (!picture) continue;
    const auto width = static_cast<float>(picture->whole().width()),
               height = static_cast<float>(picture->whole().height());
    const auto square_of = [&](const Floats2& step) {
      const float x = step.x[i] * width, y = step.y[i] * height;
      return x * x + y * y;
    };
    const Float3 light =
        light_at(*picture, std::max(square_of(points.per_u), square_of(points.per_v)), points.at.x[i], points.at.y[i]);
    result.x[i] = light.x;
    result.y[i] = light.y;
    result.z[i] = light.z;
  }
  return result;
}

}  // namespace murosimf::render::software
