/// picture_reading.h - the colors in the bytes of a PNG or JPEG file.
#pragma once

#include <cstdint>
#include <string>

#include "murosimf/imaging/image.h"

namespace murosimf::render {

constexpr std::int64_t most_read_pixels =
    4096LL * 4096;  ///< of a picture; larger ones are refused before they are read

/// Throws SetupError if a picture of this size is not read.
void check_picture_size(std::int64_t width, std::int64_t height);

/// All kinds of PNG as 8 bits of red, green and blue, sRGB; transparency is left out. Throws SetupError, without the file's name: too large,
/// not a PNG file, or what libpng says; or that this build has no pictures.
[[nodiscard]] imaging::ColorImage picture_of_png(const std::string& bytes);
/// JPEG in gray or YCbCr, likewise. Also throws for pictures that end too early or have broken parts.
[[nodiscard]] imaging::ColorImage picture_of_jpeg(const std::string& bytes);
/// One of them, by the first bytes.
[[nodiscard]] imaging::ColorImage picture_of_file(const std::string& bytes);

}  // namespace murosimf::render
