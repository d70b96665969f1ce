#include "murosimf/sensors/camera_spec.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/imaging/bayer.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::sensors {
namespace {

constexpr double largest_picture = 8192;  // [px]

using Row = OptionTable<CameraOptions>::Row;

std::vector<std::string> texts_of(const std::vector<std::string_view>& names) { return {names.begin(), names.end()}; }

std::vector<Row> lens_rows() {
  using Options = CameraOptions;
  std::vector<Row> rows{
      {"width", [](auto& of) -> decltype(auto) { return (of.camera.lens.width); }, "px", "of the picture", 1,
       largest_picture},
      {"height", [](auto& of) -> decltype(auto) { return (of.camera.lens.height); }, "px", "of the picture", 1,
       largest_picture},
      {"fov", &Options::fov, "rad", "field of view, from the left to the right border; unless there is fx", 0,
       widest_fov},
      {"lens", &Options::lens, "", "its model; without it as its coefficients say", texts_of(imaging::lens_models())},
      {"calibration", &Options::calibration, "",
       "a file in the YAML form of ROS, or Calib_Results.m, that says size and lens"},
      {"fx", &Options::fx, "px", "focal length; without it as fov says"},
      {"fy", &Options::fy, "px", "focal length; without it fx"},
      {"cx", &Options::cx, "px", "where the axis meets the picture; without it in the middle"},
      {"cy", &Options::cy, "px", "the same, from the top"},
      {"skew", [](auto& of) -> decltype(auto) { return (of.camera.lens.skew); }, "px",
       "by which a pixel moves right per unit of y'"},
  };
  for (std::size_t i = 0; i < all_lens_coefficients.size(); ++i) {
    rows.emplace_back(
        all_lens_coefficients[i], [i](auto& of) -> decltype(auto) { return (of.coefficients[i]); }, "1",
        "coefficient of the lens model that has it");
  }
  return rows;
}

std::vector<Row> light_rows() {
  return {
      {"color", [](auto& of) -> decltype(auto) { return (of.camera.layers.color); }, "", "its frames have colors"},
      {"depth", [](auto& of) -> decltype(auto) { return (of.camera.layers.depth); }, "", "its frames have depths"},
      {"labels", [](auto& of) -> decltype(auto) { return (of.camera.layers.labels); }, "",
       "its frames say what is seen"},
      {"always_on", [](auto& of) -> decltype(auto) { return (of.camera.always_on); }, "",
       "draws also if its frames are not read"},
      {"mosaic", [](auto& of) -> decltype(auto) { return (of.camera.mosaic); }, "", "Bayer pattern; without it colors",
       texts_of(imaging::bayer_patterns())},
      {"resolution", [](auto& of) -> decltype(auto) { return (of.camera.resolution); }, "1",
       "drawn pixels to one of the picture, where a lens distorts", 0.1, 4},
      {"blur", [](auto& of) -> decltype(auto) { return (of.camera.blur); }, "px", "deviation of a Gaussian blur", 0,
       50},
      {"exposure", [](auto& of) -> decltype(auto) { return (of.camera.exposure); }, "1", "brightness, linear",
       above(0)},
      {"vignetting", [](auto& of) -> decltype(auto) { return (of.camera.vignetting); }, "1",
       "share of the light that is missing in the corners", 0, 1},
      {"white_balance", [](auto& of) -> decltype(auto) { return (of.camera.white_balance); }, "1",
       "factors of red, green and blue light, after the noise", above(0), 10},
      {"exposure_time", [](auto& of) -> decltype(auto) { return (of.camera.exposure_time); }, "s",
       "of each row: what moves is blurred", 0, 1},
      {"motion_samples", [](auto& of) -> decltype(auto) { return (of.camera.motion_samples); }, "1",
       "views that are averaged for that", 1, 64},
      {"readout_time", [](auto& of) -> decltype(auto) { return (of.camera.readout_time); }, "s",
       "from the first row to the last (rolling shutter)", 0, 1},
      {"readout_bands", [](auto& of) -> decltype(auto) { return (of.camera.readout_bands); }, "1",
       "groups of rows that are exposed together", 1, largest_picture},
      {"shot_noise", [](auto& of) -> decltype(auto) { return (of.camera.shot_noise); }, "1",
       "deviation at full brightness; as the root of light", 0, 1},
      {"read_noise", [](auto& of) -> decltype(auto) { return (of.camera.read_noise); }, "1",
       "deviation everywhere, of full brightness", 0, 1},
  };
}

/// Nothing if it is not given.
const std::optional<double>& coefficient(const CameraOptions& options, std::string_view name) {
  const auto found = std::ranges::find(all_lens_coefficients, name);
  MUROSIMF_ASSERT(found != all_lens_coefficients.end());
  return options.coefficients[static_cast<std::size_t>(found - all_lens_coefficients.begin())];
}

std::string lens_model(const CameraOptions& options) {
  if (!options.lens.empty()) return options.lens;
  if (coefficient(options, "a1")) return "ray_polynomial";
  return coefficient(options, "k1") ? "plumb_bob" : "perspective";
}

std::vector<double> coefficients(const CameraOptions& options, const std::string& model) {
  const std::vector<std::string> keys = lens_coefficients(model);
  // a coefficient of another model is most likely a mistake
  for (const std::string_view key : all_lens_coefficients) {
    if (coefficient(options, key) && std::ranges::find(keys, key) == keys.end()) {
      throw SetupError(fmt::format("'{}' is no coefficient of the lens model '{}' (it has {})", key, model,
                                   keys.empty() ? "none" : fmt::format("{}", fmt::join(keys, ", "))));
    }
  }
  std::vector<double> values;
  for (const std::string& key : keys) values.push_back(coefficient(options, key).value_or(0));
  return values;
}

/// [px] The focal length with which the lens sees `fov` [rad] from the left to the right.
double focal_length(imaging::LensSpec lens, double fov) {
  lens.fx = lens.fy = 1;  // at a focal length of 1 px the border's position is the factor
  lens.cx = lens.cy = lens.skew = 0;
  const auto border = imaging::Lens(lens).project({std::sin(0.5 * fov), 0, std::cos(0.5 * fov)});
  if (!border || !(border->u > 0)) {
    throw SetupError(
        fmt::format("a {} lens cannot see {:.4g} rad; say 'fx' instead of 'fov', or another lens", lens.model, fov));
  }
  return 0.5 * lens.width / border->u;
}

imaging::LensSpec lens_of(const CameraOptions& options) {
  imaging::LensSpec lens = options.camera.lens;
  lens.model = lens_model(options);
  lens.coefficients = coefficients(options, lens.model);
  lens.cx = options.cx.value_or(0.5 * (lens.width - 1));
  lens.cy = options.cy.value_or(0.5 * (lens.height - 1));
  lens.fx = options.fx ? *options.fx : focal_length(lens, std::min(options.fov, 2 * pi));
  lens.fy = options.fy.value_or(lens.fx);
  return lens;
}

}  // namespace

const OptionTable<CameraOptions>& camera_options() {
  static const OptionTable<CameraOptions> table = [] {
    std::vector<Row> rows = lens_rows();
    std::ranges::move(light_rows(), std::back_inserter(rows));
    return OptionTable<CameraOptions>(std::move(rows));
  }();
  return table;
}

std::vector<std::string> lens_coefficients(std::string_view model) {
  if (model == "plumb_bob") return {"k1", "k2", "p1", "p2", "k3"};
  if (model == "rational_polynomial") return {"k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6"};
  if (model == "equidistant") return {"k1", "k2", "k3", "k4"};
  if (model == "ray_polynomial") return {"a1", "a2", "a3", "a4", "a5", "a6"};
  return {};
}

CameraSpec camera_spec(const SensorSpec& spec) {
  const CameraOptions options = options_of(spec, camera_options());
  CameraSpec camera = options.camera;
  camera.lens = lens_of(options);
  if (!camera.layers.color && !camera.layers.depth && !camera.layers.labels) {
    throw SetupError("the camera shows nothing: one of 'color', 'depth' and 'labels' must be true");
  }
  // more bands than rows would be empty ones
  camera.readout_bands = std::min(camera.readout_bands, camera.lens.height);
  return camera;
}

}  // namespace murosimf::sensors
