#include "murosimf/render/software/seen_solids.h"

namespace murosimf::render::software {

Float3 linear_color(const std::array<std::uint8_t, 4>& srgb) {
  // a polynomial close to the curve of sRGB, as the shaders have it
  const auto linear = [](std::uint8_t byte) {
    const float c = static_cast<float>(byte) / 255;
    return c * (c * (c * (0.50308F - 0.10041F * c) + 0.56448F) + 0.03285F);
  };
  return {linear(srgb[0]), linear(srgb[1]), linear(srgb[2])};
}

}  // namespace murosimf::render::software
