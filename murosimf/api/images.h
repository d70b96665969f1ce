/// images.h - pictures of the library as plain rows of numbers.
#pragma once

#include "murosimf/imaging/image.h"
#include "murosimf/sensors.h"

namespace murosimf::api {

/// A copy of the layers that are there; all that are have one size.
[[nodiscard]] Image image_of(const imaging::ColorImage& color, const imaging::GrayImage& mosaic,
                             const imaging::DepthImage& depth, const imaging::LabelImage& labels);

}  // namespace murosimf::api
