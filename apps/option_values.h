/// option_values.h - values of options that several commands have: sizes of pictures, speeds.
#pragma once

#include <optional>
#include <string>

#include "murosimf/world/time.h"

namespace murosimf::app {

struct PictureSize {
  int width = 0, height = 0;  ///< [px]
};

/// "1280x720", each from 1 to 8192, as given to --size. Throws SetupError.
[[nodiscard]] PictureSize read_size(const std::string& text);

/// "max" (nothing) or a number, as given to --speed. Throws SetupError.
[[nodiscard]] std::optional<double> read_speed(const std::string& text);

/// Simulated seconds, as given to --duration. Throws SetupError.
[[nodiscard]] Duration read_duration(double s);

}  // namespace murosimf::app
