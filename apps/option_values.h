/// option_values.h - values of options that several commands have: sizes of pictures, speeds.
#pragma once

#include <optional>
#include <string>

#include "murosimf/world/time.h"

namespace murosimf::app {

struct PictureSize {
  int width = 0, height = 0;  ///< [px]
};

/// Two whole numbers from 1 to 8192, as "1280x720"; nothing: it is something else.
[[nodiscard]] std::optional<PictureSize> size_in(const std::string& text);

/// "1280x720", each from 1 to 8192, as given to --size. Throws SetupError.
[[nodiscard]] PictureSize read_size(const std::string& text);

/// Of --fps and --slow of a video. Throws SetupError.
void check_rates(double fps, double slow);

/// Of --light: a name of render/light.h. Throws SetupError with the nearest one.
void check_light(const std::string& name);

/// "max" (nothing) or a number, as given to --speed. Throws SetupError.
[[nodiscard]] std::optional<double> read_speed(const std::string& text);

/// Simulated seconds, as given to --duration. Throws SetupError.
[[nodiscard]] Duration read_duration(double s);

}  // namespace murosimf::app
