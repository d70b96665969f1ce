#include "murosimf/render/software/fine_pile.h"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "murosimf/math/assert.h"

namespace murosimf::render::software {
namespace {

constexpr int level_count = std::bit_width(static_cast<unsigned>(pile_side));

/// Half as many heights to each side.
std::vector<float> halved(const std::vector<float>& heights, std::size_t side) {
  MUROSIMF_ASSERT(heights.size() == side * side && side % 2 == 0);
  std::vector<float> means;
  for (std::size_t row = 0; row < side; row += 2) {
    for (std::size_t column = 0; column < side; column += 2) {
      const float* at = &heights[row * side + column];
      means.push_back(0.25F * (at[0] + at[1] + at[side] + at[side + 1]));
    }
  }
  return means;
}

/// The power of two that is not above x > 0, as its exponent, and how far x is on its way to the next one.
struct Octave {
  explicit Octave(float x) {
    const auto bits = std::bit_cast<std::uint32_t>(x);
    exponent = static_cast<int>(bits >> 23U) - 127;
    share = static_cast<float>(bits & 0x7fffffU) * 0x1p-23F;
  }
  int exponent;
  float share;
};

}  // namespace

const FinePile& FinePile::get() {
  static const FinePile made;
  return made;
}

FinePile::FinePile() {
  std::vector<float> heights;
  for (const std::uint8_t height : pile()) heights.push_back(static_cast<float>(height) / 255 - 0.5F);
  levels_.push_back(heights);
  for (std::size_t side = pile_side; side > 1; side /= 2) levels_.push_back(halved(levels_.back(), side));
  MUROSIMF_ASSERT(levels_.size() == std::size_t{level_count});
}

float FinePile::at_level(int level, float x, float y) const {
  const int side = pile_side >> level;
  const float scale = 1.0F / static_cast<float>(1 << level);
  const float u = x * scale - 0.5F, v = y * scale - 0.5F;
  const int column = static_cast<int>(u) - (u < 0 ? 1 : 0), row = static_cast<int>(v) - (v < 0 ? 1 : 0);
  const float to_right = u - static_cast<float>(column), down = v - static_cast<float>(row);
  const std::vector<float>& heights = levels_[static_cast<std::size_t>(level)];
  const auto height = [&](int r, int c) {
    return heights[static_cast<std::size_t>((r & (side - 1)) * side + (c & (side - 1)))];  // it repeats
  };
  const float above = height(row, column) + (height(row, column + 1) - height(row, column)) * to_right;
  const float below = height(row + 1, column) + (height(row + 1, column + 1) - height(row + 1, column)) * to_right;
  return above + (below - above) * down;
}

Floats FinePile::at(const Floats2& place, const Floats& covered) const {
  constexpr auto per_meter = static_cast<float>(1 / pile_texel);
  constexpr auto period = static_cast<float>(pile_side);
  const Floats texels = limited(covered * per_meter, 1, period);
  const auto wrapped = [&](const Floats& x) { return period * fraction(x * (per_meter / period)); };
  const Floats x = wrapped(place.x), y = wrapped(place.y);
  Floats heights{};
  for (int i = 0; i < pixel_lanes; ++i) {
    const Octave octave(texels[i]);
    if (octave.exponent >= level_count - 2) continue;  // even from there
    const float fine = at_level(octave.exponent, x[i], y[i]), coarse = at_level(octave.exponent + 1, x[i], y[i]);
    heights[i] = fine + (coarse - fine) * octave.share;
  }
  return heights;
}

}  // namespace murosimf::render::software
