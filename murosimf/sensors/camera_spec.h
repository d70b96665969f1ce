/// camera_spec.h - what a camera is: lens, picture, and what becomes of its light.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/imaging/lens.h"
#include "murosimf/sensors/sensor_options.h"
#include "murosimf/sensors/sensor_spec.h"
#include "murosimf/sensors/view_source.h"

namespace murosimf::sensors {

struct CameraSpec {
  imaging::LensSpec lens{};
  Layers layers{};
  bool always_on = false;    ///< draws also if no algorithm reads its frames
  double resolution = 1;     ///< [1] drawn pixels to a pixel of the picture, where a lens distorts (lens_map.h)
  double blur = 0;           ///< [px] standard deviation of a Gaussian blur
  double exposure = 1;       ///< [1] brightness of the picture, linear; 2 is one stop more
  double exposure_time = 0;  ///< [s] of each row: what moves is blurred
  int motion_samples = 8;    ///< [1] views that are averaged for that
  double readout_time = 0;   ///< [s] from the first row to the last one (rolling shutter)
  int readout_bands = 24;    ///< [1] groups of rows that are exposed together
  double shot_noise = 0;     ///< [1] standard deviation at full brightness, of full brightness; as the root of light
  double read_noise = 0;     ///< [1] standard deviation everywhere, of full brightness
  double vignetting = 0;     ///< [1] share of the light that is missing in the corners
  Vec3d white_balance{1, 1, 1};  ///< [1] factors of red, green and blue light, after the noise
  std::string mosaic{};          ///< Bayer pattern: "rggb", "bggr", "grbg", "gbrg"; empty: colors
};

/// Names of all coefficients that lens models have.
inline constexpr std::array<std::string_view, 14> all_lens_coefficients{"k1", "k2", "k3", "k4", "k5", "k6", "p1",
                                                                        "p2", "a1", "a2", "a3", "a4", "a5", "a6"};

/// What a file may say of a camera.
struct CameraOptions {
  std::string calibration{};  ///< file that says size and lens; read where files are (sensor_table.h)
  std::string lens{};         ///< model; empty: as its coefficients say
  double fov = pi / 3;        ///< [rad] from the left to the right border
  std::optional<double> fx{}, fy{}, cx{}, cy{};  ///< [px]
  std::array<std::optional<double>, all_lens_coefficients.size()> coefficients{};
  CameraSpec camera{};  ///< all the rest, and the size of the picture
};

[[nodiscard]] const OptionTable<CameraOptions>& camera_options();

/// Their keys of the coefficients of a lens model, in its order; none for a model without or an unknown one.
[[nodiscard]] std::vector<std::string> lens_coefficients(std::string_view model);

/// Without focal length it follows from `fov`; without center it is in the middle; k1 alone makes a lens plumb_bob. Throws SetupError that names the number that is impossible.
[[nodiscard]] CameraSpec camera_spec(const SensorSpec& spec);

}  // namespace murosimf::sensors
