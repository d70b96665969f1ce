/// caption.h - a line of words over the lower edge of a picture.
#pragma once

#include <string>

#include "murosimf/imaging/image.h"

namespace murosimf::render {

/// White on a dark bar, 1/24 of the picture's height but 10 pixels at least. Throws SetupError if this build has no pictures.
void draw_caption(imaging::ColorImage& picture, const std::string& words);

}  // namespace murosimf::render
