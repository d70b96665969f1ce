/// png_bytes.h - pictures as the bytes of PNG files.
///
/// Their pixels are not filtered, and compressed at level 4 of zlib: that takes a sixth of the time that libpng's own choice takes for
/// pictures of scenes, for files of the same size (1280x720: 43 ms instead of 270).
#pragma once

#include <string>

#include "murosimf/imaging/image.h"

namespace murosimf::render {

// 8 bits per color, 8 bits gray, 16 bits gray. Throw SetupError if this build has no pictures.
[[nodiscard]] std::string png_bytes(const imaging::ColorImage& image);
[[nodiscard]] std::string png_bytes(const imaging::GrayImage& image);
[[nodiscard]] std::string png_bytes(const imaging::NumberImage& image);

}  // namespace murosimf::render
