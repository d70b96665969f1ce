/// picture_light.h - the light of the pictures of surfaces where pixels show them.
#pragma once

#include "murosimf/imaging/mip_picture.h"
#include "murosimf/render/software/float_lanes.h"
#include "murosimf/render/software/patterns.h"

namespace murosimf::render::software {

/// [1] Linear light of a picture, which repeats, at places [1] to the right and down from its upper left corner: mixed from the four nearest
/// pixels of each of the two sizes next to that in which the longer of the steps `per_u`, `per_v` to the next pixel goes over one of its
/// pixels, as OpenGL has it. Places that are not finite have some color.
[[nodiscard]] Floats3 picture_light(const imaging::MipPicture& picture, const Floats2& at, const Floats2& per_u,
                                    const Floats2& per_v);

}  // namespace murosimf::render::software
