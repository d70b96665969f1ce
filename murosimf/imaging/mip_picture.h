/// mip_picture.h - pictures that repeat over surfaces, in all sizes.
///
/// A surface that is far away, or seen at a flat angle, shows many pixels of its picture in one: it takes them from a smaller one.
/// Source: Williams, "Pyramidal parametrics", SIGGRAPH 1983.
#pragma once

#include <vector>

#include "murosimf/imaging/image.h"

namespace murosimf::imaging {

/// A picture, then it with half of its width and height, rounded down, and so on to a single pixel.
struct MipPicture {
  std::vector<ColorImage> levels;
  [[nodiscard]] const ColorImage& whole() const { return levels.front(); }
};

/// The pixels of a smaller picture are means of the light of the pixels that they cover. `picture` must not be empty.
[[nodiscard]] MipPicture mip_picture(ColorImage picture);

}  // namespace murosimf::imaging
