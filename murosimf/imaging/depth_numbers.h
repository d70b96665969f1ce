/// depth_numbers.h - depths as whole numbers of millimeters, which files and other programs take.
#pragma once

#include "murosimf/imaging/image.h"

namespace murosimf::imaging {

/// [mm] along the optical axis, rounded; 0: nothing is there, or no number; 65535: 65.535 m or farther.
/// Source: ROS REP 118, depth images of 16 bits.
[[nodiscard]] NumberImage millimeters(const DepthImage& depth);

}  // namespace murosimf::imaging
