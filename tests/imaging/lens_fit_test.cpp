#include "murosimf/imaging/lens_fit.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "murosimf/model/error.h"
#include "tests/law.h"

namespace murosimf::imaging {
namespace {

Lens lens_of(const std::string& model, const std::vector<double>& coefficients, double focal_length = 430) {
  return Lens({.model = model,
               .width = 640,
               .height = 480,
               .fx = focal_length,
               .fy = 1.01 * focal_length,
               .cx = 325,
               .cy = 236,
               .coefficients = coefficients});
}

std::string message(const Lens& lens, const std::string& model) {
  try {
    static_cast<void>(fit_lens(lens, model));
  } catch (const SetupError& error) {
    return error.what();
  }
  return "nothing was thrown";
}

/// The largest distance between where both see the rays of all pixels.
double largest_distance(const Lens& a, const Lens& b) {
  double largest = 0;
  for (int v = 0; v < 480; ++v) {
    for (int u = 0; u < 640; ++u) {
      const auto pixel = b.project(a.ray({double(u), double(v)}).value());
      largest = std::max(largest, pixel ? std::hypot(pixel->u - u, pixel->v - v) : 1e9);
    }
  }
  return largest;
}

TEST(LensFit, FindsTheSameLensWhereTheOtherModelHasIt) {
  struct Case {
    Lens lens;
    const char* model;
    std::vector<double> coefficients;
  };
  const std::vector<Case> cases{{lens_of("equidistant", {0.08, -0.02}), "ray_polynomial", {1, 0, 0.08, 0, -0.02, 0}},
                                {lens_of("ray_polynomial", {1, 0, -0.05, 0, 0.004}),
                                 "equidistant",
                                 {-0.05, 0.004, 0, 0}},
                                {lens_of("plumb_bob", {0, 0, 0, 0, 0}), "perspective", {}},
                                {lens_of("perspective", {}), "plumb_bob", {0, 0, 0, 0, 0}}};
  for (const auto& [lens, model, coefficients] : cases) {
    const LensFit fit = fit_lens(lens, model);
    law::expect_below({.law = "lens in the words of another model that has it",
                       .level = fmt::format("{} as {}", lens.spec().model, model),
                       .source = "the same formula"},
                      fit.largest_error, 1e-6, "px");
    ASSERT_EQ(fit.spec.coefficients.size(), coefficients.size());
    for (std::size_t i = 0; i < coefficients.size(); ++i) {
      EXPECT_NEAR(fit.spec.coefficients[i], coefficients[i], 1e-6) << model << ' ' << i;
    }
    EXPECT_NEAR(fit.spec.fx, lens.spec().fx, 1e-6);
    EXPECT_NEAR(fit.spec.cy, lens.spec().cy, 1e-6);
  }
}

// The skew of a lens that has one is fitted with the rest.
TEST(LensFit, KeepsSkew) {
  LensSpec spec = lens_of("plumb_bob", {-0.28, 0.08, 0.002, -0.001}).spec();
  spec.skew = 6;
  const LensFit fit = fit_lens(Lens(spec), "rational_polynomial");
  EXPECT_LT(fit.largest_error, 1e-3);
  EXPECT_NEAR(fit.spec.skew, 6, 1e-3);
}

TEST(LensFit, NamesItsLargestError) {
  const Lens lens = lens_of("plumb_bob", {-0.28, 0.08, 0.002, -0.001});
  for (const char* model : {"perspective", "rational_polynomial", "equidistant", "ray_polynomial"}) {
    const LensFit fit = fit_lens(lens, model);
    const double brute = largest_distance(lens, Lens(fit.spec));
    EXPECT_LE(fit.largest_error, brute + 1e-9) << model;
    EXPECT_NEAR(fit.largest_error, brute, 0.02 * brute + 1e-9) << model;
    const auto seen = Lens(fit.spec).project(lens.ray(fit.where).value());
    EXPECT_NEAR(std::hypot(seen->u - fit.where.u, seen->v - fit.where.v), fit.largest_error, 1e-9) << model;
  }
  EXPECT_LT(fit_lens(lens, "rational_polynomial").largest_error, 1e-3) << "plumb_bob is a part of it";
  EXPECT_LT(fit_lens(lens, "ray_polynomial").usual_error, 0.8);
  EXPECT_GT(fit_lens(lens, "perspective").usual_error, 2);
}

TEST(LensFit, KeepsALensOfTheSameModel) {
  const Lens lens = lens_of("plumb_bob", {-0.28, 0.08, 0.002, -0.001});
  const LensFit fit = fit_lens(lens, "plumb_bob");
  EXPECT_EQ(fit.spec.coefficients, lens.spec().coefficients);
  EXPECT_EQ(fit.largest_error, 0);
}

TEST(LensFit, RefusesWhatTheOtherModelCannotShow) {
  const Lens wide = lens_of("equidistant", {0.0}, 200);
  EXPECT_NE(message(wide, "plumb_bob").find("'plumb_bob' cannot show rays 11"), std::string::npos)
      << message(wide, "plumb_bob");
  EXPECT_EQ(message(wide, "plumbob"), "unknown lens model 'plumbob'; did you mean 'plumb_bob'?");
}

}  // namespace
}  // namespace murosimf::imaging
