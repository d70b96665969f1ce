#include "murosimf/sensors/camera_spec.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/model/error.h"
#include "murosimf/sensors/numbers.h"

namespace murosimf::sensors {
namespace {

constexpr double largest_picture = 8192;  // [px]

std::string text(const SensorSpec& spec, const std::string& key) {
  const auto found = spec.texts.find(key);
  return found == spec.texts.end() ? std::string() : found->second;
}

bool flag(const SensorSpec& spec, const std::string& key, bool otherwise) {
  return spec.number(key, otherwise ? 1 : 0) != 0;
}

std::string lens_model(const SensorSpec& spec) {
  if (std::string named = text(spec, "lens"); !named.empty()) return named;
  if (spec.numbers.contains("a1")) return "ray_polynomial";
  return spec.numbers.contains("k1") ? "plumb_bob" : "perspective";
}

std::vector<double> coefficients(const SensorSpec& spec, const std::string& model) {
  const std::vector<std::string> keys = lens_coefficients(model);
  for (const char* key : {"k1", "k2", "k3", "k4", "k5", "k6", "p1", "p2", "a1", "a2", "a3", "a4", "a5", "a6"}) {
    if (spec.numbers.contains(key) && std::find(keys.begin(), keys.end(), key) == keys.end()) {
      throw SetupError(fmt::format("'{}' is no coefficient of the lens model '{}' (it has {})", key, model,
                                   keys.empty() ? "none" : fmt::format("{}", fmt::join(keys, ", "))));
    }
  }
  std::vector<double> values;
  for (const std::string& key : keys) values.push_back(spec.number(key, 0));
  return values;
}

/// [px] The focal length with which the lens sees `fov` [rad] from the left to the right.
double focal_length(imaging::LensSpec lens, double fov) {
  lens.fx = lens.fy = 1;
  lens.cx = lens.cy = 0;
  const auto border = imaging::Lens(lens).project({std::sin(0.5 * fov), 0, std::cos(0.5 * fov)});
  if (!border || !(border->u > 0)) {
    throw SetupError(
        fmt::format("a {} lens cannot see {:.4g} rad; say 'fx' instead of 'fov', or another lens", lens.model, fov));
  }
  return 0.5 * lens.width / border->u;
}

imaging::LensSpec lens_of(const SensorSpec& spec) {
  imaging::LensSpec lens{.model = lens_model(spec)};
  lens.width = checked_count(spec, "width", 640, {1, largest_picture});
  lens.height = checked_count(spec, "height", 480, {1, largest_picture});
  lens.coefficients = coefficients(spec, lens.model);
  lens.cx = spec.number("cx", 0.5 * (lens.width - 1));
  lens.cy = spec.number("cy", 0.5 * (lens.height - 1));
  lens.fx = spec.number("fx", 0);
  if (!spec.numbers.contains("fx")) lens.fx = focal_length(lens, checked_fov(spec, "fov", pi / 3));
  lens.fy = spec.number("fy", lens.fx);
  return lens;
}

}  // namespace

std::vector<std::string> lens_coefficients(std::string_view model) {
  if (model == "plumb_bob") return {"k1", "k2", "p1", "p2", "k3"};
  if (model == "rational_polynomial") return {"k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6"};
  if (model == "equidistant") return {"k1", "k2", "k3", "k4"};
  if (model == "ray_polynomial") return {"a1", "a2", "a3", "a4", "a5", "a6"};
  return {};
}

CameraSpec camera_spec(const SensorSpec& spec) {
  CameraSpec camera;
  camera.lens = lens_of(spec);
  camera.layers = {flag(spec, "color", true), flag(spec, "depth", false), flag(spec, "labels", false)};
  if (!camera.layers.color && !camera.layers.depth && !camera.layers.labels) {
    throw SetupError("the camera shows nothing: one of 'color', 'depth' and 'labels' must be true");
  }
  camera.always_on = flag(spec, "always_on", false);
  camera.resolution = checked_number(spec, "resolution", 1, {0.1, 4});
  camera.blur = checked_number(spec, "blur", 0, {0, 50});
  camera.exposure = checked_positive(spec, "exposure", 1);
  camera.exposure_time = checked_number(spec, "exposure_time", 0, {0, 1});
  camera.motion_samples = checked_count(spec, "motion_samples", 8, {1, 64});
  camera.readout_time = checked_number(spec, "readout_time", 0, {0, 1});
  camera.readout_bands = std::min(checked_count(spec, "readout_bands", 24, {1, largest_picture}), camera.lens.height);
  camera.shot_noise = checked_number(spec, "shot_noise", 0, {0, 1});
  camera.read_noise = checked_number(spec, "read_noise", 0, {0, 1});
  camera.mosaic = text(spec, "mosaic");
  return camera;
}

}  // namespace murosimf::sensors
