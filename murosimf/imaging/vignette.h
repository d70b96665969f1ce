/// vignette.h - pictures that are darker toward their corners, as behind most lenses.
///
/// Light at the distance r from the middle of the picture, which is 1 in its corners, is multiplied with
///
///     1 - share r^2
///
/// the first term of what natural and optical vignetting take. Source: Goldman, "Vignette and exposure calibration and compensation", IEEE
/// PAMI 32 (2010), with the higher terms left out.
#pragma once

#include <cstdint>
#include <vector>

#include "murosimf/imaging/image.h"

namespace murosimf::imaging {

class Vignette {
 public:
  /// `share` of the light that is missing in the corners, for pictures of one size [px]. Throws SetupError if it is not 0 to 1.
  Vignette(double share, int width, int height);

  void apply(ColorImage& picture) const noexcept;

 private:
  int width_, height_;
  std::vector<std::uint16_t> column_, row_;  ///< share of the light that is missing, of 65536: r^2 is the sum of both
};

}  // namespace murosimf::imaging
