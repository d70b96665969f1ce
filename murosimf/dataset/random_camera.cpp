#include "murosimf/dataset/random_camera.h"

#include <cmath>

#include "murosimf/math/scalar.h"
#include "murosimf/model/error.h"

namespace murosimf::dataset {
namespace {

constexpr int motion_samples = 5;
constexpr int most_lens_tries = 50;  // for a lens that does not fold

std::string random_model(const LensRanges& ranges, Dice& dice) {
  const double draw = dice.uniform() * (ranges.perspective + ranges.plumb_bob + ranges.equidistant);
  if (draw < ranges.perspective) return "perspective";
  return draw < ranges.perspective + ranges.plumb_bob ? "plumb_bob" : "equidistant";
}

/// [px] With which half of `fov` [rad] is seen at the border; nothing if the lens cannot see it.
std::optional<double> focal_length(imaging::LensSpec lens, double fov) {
  lens.fx = lens.fy = 1;
  lens.cx = lens.cy = 0;
  const auto border = imaging::Lens(lens).project({std::sin(0.5 * fov), 0, std::cos(0.5 * fov)});
  if (!border || !(border->u > 0)) return std::nullopt;
  return 0.5 * lens.width / border->u;
}

/// Nothing if the lens that is drawn folds over inside the picture.
std::optional<imaging::LensSpec> random_lens(const LensRanges& ranges, int width, int height, Dice& dice) {
  imaging::LensSpec lens{.model = random_model(ranges, dice), .width = width, .height = height};
  const double k1 = dice.in(ranges.k1), k2 = dice.in(ranges.k2), p1 = dice.in(ranges.p), p2 = dice.in(ranges.p);
  if (lens.model == "plumb_bob") lens.coefficients = {k1, k2, p1, p2, 0};
  if (lens.model == "equidistant") lens.coefficients = {0.2 * k1, 0.2 * k2, 0, 0};
  const double fov = dice.in(ranges.fov_deg) * pi / 180;
  const auto focal = focal_length(lens, fov);
  if (!focal) return std::nullopt;
  lens.fx = lens.fy = *focal;
  lens.cx = 0.5 * (width - 1) + dice.in({-0.02, 0.02}) * width;
  lens.cy = 0.5 * (height - 1) + dice.in({-0.02, 0.02}) * height;
  if (!imaging::Lens(lens).fold_warning().empty()) return std::nullopt;
  return lens;
}

}  // namespace

std::vector<imaging::LensSpec> random_lenses(const LensRanges& ranges, int width, int height, std::uint64_t seed) {
  std::vector<imaging::LensSpec> lenses;
  const auto count = static_cast<std::size_t>(ranges.count);
  for (std::size_t i = 0; i < count; ++i) {
    Dice dice(seed, "lens", i);
    std::optional<imaging::LensSpec> lens;
    for (int tries = 0; !lens && tries < most_lens_tries; ++tries) lens = random_lens(ranges, width, height, dice);
    if (!lens) throw SetupError("[lens]: nearly all lenses of these ranges fold over inside the picture");
    lenses.push_back(*lens);
  }
  return lenses;
}

sensors::CameraSpec random_camera(const SensorRanges& ranges, const imaging::LensSpec& lens, Dice& dice) {
  sensors::CameraSpec camera;
  camera.lens = lens;
  camera.layers = {true, true, true};
  camera.exposure = dice.in(ranges.exposure);
  const double red = dice.in(ranges.white_balance), blue = dice.in(ranges.white_balance);
  camera.white_balance = {1 + red, 1, 1 + blue};
  camera.vignetting = dice.in(ranges.vignetting);
  const double blur = dice.in(ranges.blur);
  if (blur > 0.2) camera.blur = blur;  // less is not seen
  camera.shot_noise = dice.in(ranges.shot_noise);
  camera.read_noise = dice.in(ranges.read_noise);
  const double exposure_time = dice.in(ranges.exposure_time);
  if (!dice.chance(ranges.motion_blur)) return camera;
  camera.exposure_time = exposure_time;
  camera.motion_samples = motion_samples;
  return camera;
}

}  // namespace murosimf::dataset
