/// jpeg_bytes.h - pictures as the bytes of JPEG files.
#pragma once

#include <string>

#include "murosimf/imaging/image.h"

namespace murosimf::dataset {

/// JPEG (JFIF, sRGB, colors at half the size). `quality` 1 to 100. Throws SetupError if this build cannot.
[[nodiscard]] std::string jpeg_bytes(const imaging::ColorImage& image, int quality);

/// Throws SetupError that says what is missing, if this build writes no data sets.
void check_jpeg_bytes();

}  // namespace murosimf::dataset
