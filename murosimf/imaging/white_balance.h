/// white_balance.h - pictures of a camera that takes another color for white: light of each color times a factor of its own.
#pragma once

#include <array>
#include <cstdint>

#include "murosimf/imaging/image.h"
#include "murosimf/math/vec3.h"

namespace murosimf::imaging {

class WhiteBalance {
 public:
  /// `gains` [1] of red, green and blue light. Throws SetupError if one is not above 0 and finite.
  explicit WhiteBalance(const Vec3d& gains);

  void apply(ColorImage& picture) const noexcept;

 private:
  std::array<std::array<std::uint8_t, 256>, 3> values_{};  ///< what each value of each color becomes
};

}  // namespace murosimf::imaging
