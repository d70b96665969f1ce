/// images.h - pictures of the library as plain arrays of numbers.
#pragma once

#include "murosimf/imaging/image.h"
#include "murosimf/sensors.h"

namespace murosimf::api {

/// Copies existing layers, which all have the same size.
[[nodiscard]] Image image_of(const imaging::ColorImage& color, const imaging::GrayImage& mosaic,
                             const imaging::DepthImage& depth, const imaging::LabelImage& labels);

}  // namespace murosimf::api
