// Calibrations of real robots' cameras (lenses/).
#include <array>
#include <cmath>
#include <optional>

#include <gtest/gtest.h>

#include "murosimf/component_files/camera_info.h"
#include "murosimf/imaging/lens_fit.h"
#include "murosimf/math/scalar.h"
#include "murosimf/model/error.h"
#include "tests/law.h"

namespace murosimf::component_files {
namespace {

/// Nothing in builds without yaml-cpp.
std::optional<imaging::LensSpec> calibration(const std::string& name) {
  try {
    return read_camera_info(std::string(MUROSIMF_SOURCE_DIR) + "/lenses/" + name + ".yaml").lens;
  } catch (const SetupError& error) {
    if (std::string(error.what()).find("yaml-cpp was missing") != std::string::npos) return std::nullopt;
    throw;
  }
}

double angle_between(const Vec3d& a, const Vec3d& b) { return std::atan2(norm(cross(a, b)), dot(a, b)); }

class RealLens : public testing::TestWithParam<const char*> {};

TEST_P(RealLens, ComesBackToTheRayOfEveryPixel) {
  const auto spec = calibration(GetParam());
  if (!spec) GTEST_SKIP() << "this build has no yaml-cpp";
  const imaging::Lens lens(*spec);
  law::Worst worst;
  for (int v = 0; v < spec->height; ++v) {
    for (int u = 0; u < spec->width; ++u) {
      const auto ray = lens.ray({double(u), double(v)});
      const auto pixel = ray ? lens.project(*ray) : std::nullopt;
      const auto again = pixel ? lens.ray(*pixel) : std::nullopt;
      worst.see(again ? angle_between(*ray, *again) : pi, u, v);
      // as exact in pixels, because two equal errors of rays would cancel
      if (pixel) worst.see(std::hypot(pixel->u - u, pixel->v - v) / spec->fx, u, v);
    }
  }
  law::expect_below({.law = "lens of a real robot: ray to pixel to ray, all pixels",
                     .level = fmt::format("{}, {}", GetParam(), spec->model),
                     .source = "the inverse of the inverse"},
                    worst, 1e-6, "rad");
  EXPECT_EQ(lens.fold_warning(), "");
}

INSTANTIATE_TEST_SUITE_P(Lenses, RealLens,
                         testing::Values("nubots_frankie", "nubots_nugus1", "wolfgang_rory", "wolfgang_amy"),
                         [](const auto& test) { return std::string(test.param); });

/// NUbots publish the inverse map, in widths of the picture: from the distance to the angle.
struct InversePolynomial {
  const char* name;
  double focal_length, center_x, center_y, k1, k2;
  double error;  ///< [px] that the file names
};

TEST(RealLenses, OfNubotsAreTheInversePolynomialsThatTheyPublish) {
  const std::array<InversePolynomial, 2> published{
      {{"nubots_frankie", 0.34, 0.02072339174622414, -0.0011612242293956145, 0.38553542593448015, 0.1498415334589703,
        0.005},
       {"nubots_nugus1", 0.34767878619271286, -0.01370165657132854, -0.013645629277120971, 0.46673390301927425,
        0.15017118169604132, 0.026}}};
  for (const auto& [name, focal_length, center_x, center_y, k1, k2, error] : published) {
    const auto spec = calibration(name);
    if (!spec) GTEST_SKIP() << "this build has no yaml-cpp";
    const imaging::Lens lens(*spec);
    law::Worst worst;
    for (int v = 0; v < 1024; v += 3) {
      for (int u = 0; u < 1280; u += 3) {
        const double x = (u + 0.5) / 1280 - 0.5 + center_x, y = (v + 0.5 - 512) / 1280 + center_y;
        const double r = std::hypot(x, y), r2 = r * r;
        const double angle = r * (1 + k1 * r2 + k2 * r2 * r2) / focal_length;
        const auto pixel = lens.project({x / r * std::sin(angle), y / r * std::sin(angle), std::cos(angle)});
        worst.see(pixel ? std::hypot(pixel->u - u, pixel->v - v) : 1e9, u, v);
      }
    }
    law::expect_below({.law = "lens of a real robot: pixels of rays",
                       .level = name,
                       .source = "the published polynomial from distance to angle"},
                      worst, error, "px");
  }
}

TEST(RealLenses, AreWhatTheyAreInTheWordsOfThePaper) {
  for (const char* name : {"nubots_frankie", "nubots_nugus1", "wolfgang_rory", "wolfgang_amy"}) {
    const auto spec = calibration(name);
    if (!spec) GTEST_SKIP() << "this build has no yaml-cpp";
    const imaging::LensFit fit = imaging::fit_lens(imaging::Lens(*spec), "ray_polynomial");
    EXPECT_EQ(fit.spec.coefficients.size(), 6U);
    EXPECT_EQ(fit.spec.coefficients[0], 1);
    // the paper's lens has no tangential coefficients, and six powers are few for the steep corners of plumb_bob
    const bool fisheye = spec->model == "equidistant";
    EXPECT_LT(fit.usual_error, fisheye ? 0.05 : 1.5) << name;
    EXPECT_LT(fit.largest_error, fisheye ? 0.2 : 7) << name;
  }
}

}  // namespace
}  // namespace murosimf::component_files
