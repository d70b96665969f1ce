/// camera_spec.h - what a camera is: lens, picture, and what becomes of its light.
#pragma once

#include <string>
#include <string_view>

#include "murosimf/imaging/lens.h"
#include "murosimf/sensors/sensor_spec.h"
#include "murosimf/sensors/view_source.h"

namespace murosimf::sensors {

struct CameraSpec {
  imaging::LensSpec lens{};
  Layers layers{};
  bool always_on = false;    ///< draws also if nobody reads its frames
  double resolution = 1;     ///< [1] drawn pixels to a pixel of the picture, where a lens distorts (lens_map.h)
  double blur = 0;           ///< [px] standard deviation of a Gaussian blur
  double exposure = 1;       ///< [1] brightness of the picture, linear; 2 is one stop more
  double exposure_time = 0;  ///< [s] of each row: what moves is blurred
  int motion_samples = 8;    ///< [1] views that are averaged for that
  double readout_time = 0;   ///< [s] from the first row to the last one (rolling shutter)
  int readout_bands = 24;    ///< [1] groups of rows that are exposed together
  double shot_noise = 0;     ///< [1] standard deviation at full brightness, of full brightness; as the root of light
  double read_noise = 0;     ///< [1] standard deviation everywhere, of full brightness
  std::string mosaic{};      ///< Bayer pattern: "rggb", "bggr", "grbg", "gbrg"; empty: colors
};

/// Numbers of SensorSpec that cameras know: of picture and lens, then of light.
inline constexpr std::string_view camera_numbers =
    "width height fov fx fy cx cy k1 k2 k3 k4 k5 k6 p1 p2 a1 a2 a3 a4 a5 a6 resolution blur exposure exposure_time "
    "motion_samples readout_time readout_bands shot_noise read_noise";

/// Their keys of the coefficients of a lens model, in its order; none for a model without or an unknown one.
[[nodiscard]] std::vector<std::string> lens_coefficients(std::string_view model);

/// Texts `lens` (name of the model) and `mosaic`, flags `color`, `depth`, `labels`, `always_on`, and the numbers above.
/// Without focal length it follows from `fov` [rad, from the left to the right border, default 60 deg]; without
/// center it is in the middle; k1 alone makes a lens plumb_bob. Throws SetupError that names the number that is impossible.
[[nodiscard]] CameraSpec camera_spec(const SensorSpec& spec);

}  // namespace murosimf::sensors
