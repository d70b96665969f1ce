/// random_camera.h - lenses of a data set, and what becomes of the light in one picture.
#pragma once

#include <vector>

#include "murosimf/dataset/randomisation.h"
#include "murosimf/sensors/camera_spec.h"

namespace murosimf::dataset {

/// Lenses for pictures of that size [px]; none folds over inside the picture. Throws SetupError.
[[nodiscard]] std::vector<imaging::LensSpec> random_lenses(const LensRanges& ranges, int width, int height,
                                                           std::uint64_t seed);

/// All layers, through that lens.
[[nodiscard]] sensors::CameraSpec random_camera(const SensorRanges& ranges, const imaging::LensSpec& lens, Dice& dice);

}  // namespace murosimf::dataset
