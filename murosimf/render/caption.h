/// caption.h - lines of words at the edges of a picture.
#pragma once

#include <span>
#include <string>

#include "murosimf/imaging/image.h"
#include "murosimf/model/shape.h"

namespace murosimf::render {

enum class CaptionPlace { bottom, top, top_left };

/// [px] Height that a caption takes from the edge of a picture of `height` pixels.
[[nodiscard]] double caption_room(int height);

/// White on a dark bar, 1/24 of the picture's height but 10 pixels at least. `ends`: none, or the colors of a square at its left and right
/// end. Throws SetupError if this build has no pictures.
void draw_caption(imaging::ColorImage& picture, const std::string& words, CaptionPlace place = CaptionPlace::bottom,
                  std::span<const Color> ends = {});

}  // namespace murosimf::render
