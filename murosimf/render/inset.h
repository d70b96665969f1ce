/// inset.h - a picture in the corner of another one.
#pragma once

#include <string>

#include "murosimf/imaging/image.h"

namespace murosimf::render {

/// Draws `inset` into the lower right corner, as large as fits into 0.34 of width and height, with a bright frame and its name at the upper
/// edge. A pixel is the mean light of what it covers. Throws SetupError if this build has no pictures.
void draw_inset(imaging::ColorImage& picture, const imaging::ColorImage& inset, const std::string& name);

/// The same picture with another size, at least one pixel each way.
[[nodiscard]] imaging::ColorImage scaled(const imaging::ColorImage& picture, int width, int height);

}  // namespace murosimf::render
