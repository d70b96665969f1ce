/// picture_message.h - a camera's picture as one binary message [little-endian]:
///
///     u8 2, u8 0, u16 width, u16 height, u16 0, then red, green and blue of each pixel, row by row from the top
///
/// Pictures wider or higher than `most_pixels` are reduced: every second pixel, every third, ...
#pragma once

#include <string>

#include "murosimf/sensors/camera_frame.h"

namespace murosimf::web {

inline constexpr int most_pixels = 480;  ///< [px]

/// Of its colors, its mosaic, or its depth (near is bright); empty if there is none yet.
[[nodiscard]] std::string picture_message(const sensors::CameraFrame& frame);

}  // namespace murosimf::web
