#include "murosimf/render/software/row_bytes.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "murosimf/render/software/surface_buffer.h"

namespace murosimf::render::software {
namespace {

using Pixel4 = std::uint8_t __attribute__((vector_size(16)));  // red, green, blue and another one

Ints byte_of(const Floats& share) { return whole_numbers(limited(share, 0, 1) * 255.0F + 0.5F); }

}  // namespace

void write_bytes(const RowColors& colors, const std::int32_t* numbers, std::span<imaging::Rgb> pixels) {
  static_assert(sizeof(imaging::Rgb) == 3);
  const int width = static_cast<int>(pixels.size());
  std::array<Pixel4, pixel_lanes / 4> four{};
  for (int u = 0; u < width; u += pixel_lanes) {
    if (all(load_lanes<Ints>(numbers + u) == left_out)) continue;
    const Floats3 color = colors.load(u);
    const Ints whole = byte_of(color.x) | byte_of(color.y) << 8 | byte_of(color.z) << 16;
    std::memcpy(four.data(), &whole, sizeof(whole));
    for (std::size_t i = 0; i < four.size(); ++i) {
      const int first = u + 4 * static_cast<int>(i);
      if (first >= width) return;
      const Pixel4 packed =
          __builtin_shufflevector(four[i], four[i], 0, 1, 2, 4, 5, 6, 8, 9, 10, 12, 13, 14, 3, 7, 11, 15);
      // sixteen bytes at a time, of which the next pixels cover the last four
      std::uint8_t* to = &pixels[static_cast<std::size_t>(first)].red;
      if (3 * (width - first) >= 16) {
        std::memcpy(to, &packed, 16);
      } else {
        std::memcpy(to, &packed, static_cast<std::size_t>(3 * std::min(4, width - first)));
      }
    }
  }
}

void lay_over(const Float3& color, float alpha, imaging::Rgb& pixel) {
  const auto lay = [&](float over, std::uint8_t& byte) {
    const float share = std::clamp(over, 0.0F, 1.0F) * alpha + static_cast<float>(byte) / 255 * (1 - alpha);
    byte = static_cast<std::uint8_t>(share * 255 + 0.5F);
  };
  lay(color.x, pixel.red);
  lay(color.y, pixel.green);
  lay(color.z, pixel.blue);
}

}  // namespace murosimf::render::software
