/// picture_bytes.h - pictures as the bytes of files, quickly: a data set has thousands.
#pragma once

#include <string>

#include "murosimf/imaging/image.h"

namespace murosimf::dataset {

// PNG: 8 bits per color, 8 bits gray, 16 bits gray. Throw SetupError if this build cannot.
[[nodiscard]] std::string png_bytes(const imaging::ColorImage& image);
[[nodiscard]] std::string png_bytes(const imaging::GrayImage& image);
[[nodiscard]] std::string png_bytes(const imaging::NumberImage& image);

/// JPEG (JFIF, sRGB, colors at half the size). `quality` 1 to 100. Throws SetupError if this build cannot.
[[nodiscard]] std::string jpeg_bytes(const imaging::ColorImage& image, int quality);

/// Throws SetupError that says what is missing, if this build can write none of them.
void check_picture_bytes();

}  // namespace murosimf::dataset
