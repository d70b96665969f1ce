/// picture_light.h - the light of the pictures of surfaces where pixels show them.
#pragma once

#include <array>

#include "murosimf/imaging/mip_picture.h"
#include "murosimf/render/software/float_lanes.h"
#include "murosimf/render/software/patterns.h"

namespace murosimf::render::software {

/// Where pixels are in the pictures that they show, and the steps to the next pixels.
struct PicturePoints {
  std::array<const imaging::MipPicture*, pixel_lanes> pictures{};  ///< null: none
  Floats2 at;            ///< [1] to the right and down from the upper left corner
  Floats2 per_u, per_v;  ///< [1/px]
};

/// [1] Linear light of pictures, which repeat: mixed from the four nearest pixels of each of the two sizes next to that in which the longer
/// of both steps goes over one pixel, as OpenGL has it. White without a picture; places that are not finite have some color.
[[nodiscard]] Floats3 picture_light(const PicturePoints& points);

}  // namespace murosimf::render::software
