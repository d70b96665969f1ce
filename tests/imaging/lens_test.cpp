#include "murosimf/imaging/lens.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "murosimf/math/random.h"
#include "murosimf/math/scalar.h"
#include "murosimf/model/error.h"
#include "tests/law.h"

namespace murosimf::imaging {
namespace {

LensSpec spec_of(const std::string& model, const std::vector<double>& coefficients) {
  return {.model = model,
          .width = 640,
          .height = 480,
          .fx = 420,
          .fy = 410,
          .cx = 325,
          .cy = 236,
          .coefficients = coefficients};
}

/// One lens of every model, without a fold inside the picture; the numbers are of the kind that calibrations give.
std::vector<LensSpec> lenses() {
  return {spec_of("perspective", {}), spec_of("plumb_bob", {-0.05, 0.02, 0.0011, -0.0007, 0.003}),
          spec_of("rational_polynomial", {0.9, 0.15, -0.0004, 0.0008, 0.004, 1.2, 0.3, 0.02}),
          spec_of("equidistant", {0.08, -0.02, 0.004, -0.0008}),
          spec_of("ray_polynomial", {1.1, 0.02, -0.05, 0.01, 0.004, -0.001})};
}

std::string message(const LensSpec& spec) {
  try {
    const Lens lens(spec);
  } catch (const SetupError& error) {
    return error.what();
  }
  return "nothing was thrown";
}

double angle_between(const Vec3d& a, const Vec3d& b) { return std::atan2(norm(cross(a, b)), dot(a, b)); }

/// How far off a ray is that was seen in a pixel and looked up again [rad].
law::Worst round_trip(const Lens& lens) {
  law::Worst worst;
  const LensSpec& spec = lens.spec();
  for (int v = 0; v < spec.height; ++v) {
    for (int u = 0; u < spec.width; ++u) {
      const auto ray = lens.ray({double(u), double(v)});
      const auto pixel = ray ? lens.project(3.0 * *ray) : std::nullopt;
      const auto again = pixel ? lens.ray(*pixel) : std::nullopt;
      worst.see(again ? std::max(angle_between(*ray, *again), std::hypot(pixel->u - u, pixel->v - v) / spec.fx) : pi,
                spec.model, u, v);
    }
  }
  return worst;
}

TEST(Lens, SeesTheAxisInItsCenterAndTheRightAtTheRight) {
  for (const LensSpec& spec : lenses()) {
    const Lens lens(spec);
    const auto center = lens.project({0, 0, 2}), right = lens.project({0.1, 0, 2}), down = lens.project({0, 0.1, 2});
    ASSERT_TRUE(center && right && down) << spec.model;
    EXPECT_EQ(center->u, spec.cx);
    EXPECT_EQ(center->v, spec.cy);
    EXPECT_GT(right->u, spec.cx + 10);
    EXPECT_GT(down->v, spec.cy + 10);
  }
}

TEST(Lens, ComesBackToTheRayOfEveryPixel) {
  for (const LensSpec& spec : lenses()) {
    law::expect_below({.law = "lens: ray to pixel to ray, all pixels of 640x480",
                       .level = spec.model,
                       .source = "the inverse of the inverse"},
                      round_trip(Lens(spec)), 1e-11, "rad");
  }
}

LensSpec skewed(LensSpec spec, double skew) {
  spec.skew = skew;
  return spec;
}

// u gets skew times y' = (v - cy) / fy more, whatever the model; v stays.
TEST(Lens, WithSkewSeesMoreToTheRightTheFartherDown) {
  law::Worst error, round;
  for (const LensSpec& spec : lenses()) {
    const Lens straight(spec), lens(skewed(spec, 7.5));
    EXPECT_FALSE(lens.plain());
    for (const Vec3d& point : {Vec3d{0.3, -0.2, 1}, {-0.4, 0.35, 1.1}, {0.05, 0.5, 1.4}}) {
      const Pixel seen = lens.project(point).value(), before = straight.project(point).value();
      const double u = before.u + 7.5 * (before.v - spec.cy) / spec.fy;
      error.see(std::hypot(seen.u - u, seen.v - before.v), spec.model);
    }
    const law::Measured back = round_trip(lens);
    round.see(back.value, spec.model);
  }
  law::expect_below({.law = "lens with skew: where points are seen",
                     .level = "all models",
                     .source = "u = fx x' + s y' + cx, as K[0][1] of OpenCV and alpha_c of Bouguet's toolbox"},
                    error, 1e-10, "px");
  law::expect_below({.law = "lens with skew: ray to pixel to ray, all pixels of 640x480",
                     .level = "all models",
                     .source = "the inverse of the inverse"},
                    round, 1e-11, "rad");
}

TEST(Lens, WithTooMuchSkewIsRefused) {
  EXPECT_EQ(message(skewed(spec_of("perspective", {}), 420)),
            "the skew is 420; its size must be below the focal length fx, 420, in pixels");
  EXPECT_NE(message(skewed(spec_of("perspective", {}), std::nan(""))), "nothing was thrown");
}

TEST(Lens, FollowsTheFormulasAtAPoint) {
  const double x = 0.3, y = -0.2, r2 = x * x + y * y, t = std::atan(std::sqrt(r2)), r = std::sqrt(r2);
  const auto seen = [&](std::size_t i) { return Lens(lenses()[i]).project({x, y, 1}).value(); };
  const auto u = [](double xd) { return 420 * xd + 325; };
  EXPECT_NEAR(seen(0).u, u(x), 1e-10);
  const double plumb = 1 - 0.05 * r2 + 0.02 * r2 * r2 + 0.003 * r2 * r2 * r2;
  EXPECT_NEAR(seen(1).u, u(x * plumb + 2 * 0.0011 * x * y - 0.0007 * (r2 + 2 * x * x)), 1e-10);
  const double rational =
      (1 + 0.9 * r2 + 0.15 * r2 * r2 + 0.004 * r2 * r2 * r2) / (1 + 1.2 * r2 + 0.3 * r2 * r2 + 0.02 * r2 * r2 * r2);
  EXPECT_NEAR(seen(2).v, 410 * (y * rational - 0.0004 * (r2 + 2 * y * y) + 2 * 0.0008 * x * y) + 236, 1e-10);
  const double equidistant =
      t * (1 + 0.08 * std::pow(t, 2) - 0.02 * std::pow(t, 4) + 0.004 * std::pow(t, 6) - 0.0008 * std::pow(t, 8));
  EXPECT_NEAR(seen(3).u, u(equidistant / r * x), 1e-10);
  const double powers = 1.1 * t + 0.02 * std::pow(t, 2) - 0.05 * std::pow(t, 3) + 0.01 * std::pow(t, 4) +
                        0.004 * std::pow(t, 5) - 0.001 * std::pow(t, 6);
  EXPECT_NEAR(seen(4).u, u(powers / r * x), 1e-10);
}

TEST(Lens, OfAnAngleSeesWhatIsBesideAndBehind) {
  const Lens lens(spec_of("equidistant", {0.0}));
  const auto beside = lens.project({1, 0, 0}), behind = lens.project({0, 1, -1});
  ASSERT_TRUE(beside && behind);
  EXPECT_NEAR(beside->u, 325 + 420 * pi / 2, 1e-9);
  EXPECT_NEAR(behind->v, 236 + 410 * 0.75 * pi, 1e-9);
  EXPECT_FALSE(lens.project({0, 0, -1})) << "straight behind has no direction in the picture";
  EXPECT_DOUBLE_EQ(lens.widest_angle(), pi);
}

TEST(Lens, OfThePlaneDoesNotSeeBehindIt) {
  for (const char* model : {"perspective", "plumb_bob"}) {
    const Lens lens(spec_of(model, std::string(model) == "perspective" ? std::vector<double>{}
                                                                       : std::vector<double>{0.01, 0, 0, 0}));
    EXPECT_FALSE(lens.project({0, 0, 0}));
    EXPECT_FALSE(lens.project({1, 0, 0}));
    EXPECT_FALSE(lens.project({0.1, 0, -1}));
    EXPECT_DOUBLE_EQ(lens.widest_angle(), pi / 2);
  }
}

TEST(Lens, SeesNothingBeyondItsFold) {
  // r (1 - r^2 / 3) is largest at r = 1, 45 degrees, where it is 2/3
  const Lens lens(spec_of("plumb_bob", {-1.0 / 3, 0, 0, 0}));
  law::expect_near({.law = "lens: where the distortion folds over",
                    .level = "plumb_bob",
                    .source = "r - r^3 / 3 turns"},
                   lens.widest_angle(), pi / 4, 1e-8, "rad");
  EXPECT_TRUE(lens.project({0.999, 0, 1}));
  EXPECT_FALSE(lens.project({1.001, 0, 1}));
  EXPECT_TRUE(lens.ray({325 + 420 * 0.666, 236}));
  EXPECT_FALSE(lens.ray({325 + 420 * 0.667, 236}));
  EXPECT_DOUBLE_EQ(lens.corner_angle(), lens.widest_angle());
  EXPECT_NE(lens.fold_warning().find("folds over at 45.0 deg, inside the picture: "), std::string::npos)
      << lens.fold_warning();

  const Lens bent(spec_of("equidistant", {-1.0 / 3}));  // t - t^3 / 3 turns at 1 rad
  EXPECT_NEAR(bent.widest_angle(), 1, 1e-8);
  EXPECT_FALSE(bent.project({std::tan(1.001), 0, 1}));
  EXPECT_FALSE(bent.ray({325 + 420 * 0.667, 236}));
}

TEST(Lens, WithTangentialCoefficientsFoldsWhereItsAreaVanishes) {
  const LensSpec spec = spec_of("plumb_bob", {-0.3, 0.05, 0.02, -0.03});
  const Lens lens(spec);
  const PlaneDistortion map(spec.coefficients);
  const auto area = [&](double angle, double direction) {
    const double r = std::tan(angle);
    return map.at({r * std::cos(direction), r * std::sin(direction)}).determinant();
  };
  double inside = 1, outside = 1;
  for (int i = 0; i < 3600; ++i) {
    inside = std::min(inside, area(lens.widest_angle() - 1e-3, pi * i / 1800));
    outside = std::min(outside, area(lens.widest_angle() + 1e-3, pi * i / 1800));
  }
  EXPECT_GT(inside, 0);
  EXPECT_LT(outside, 0);
}

TEST(Lens, StopsBeforeTheDenominatorVanishes) {
  // the denominator is 0 at r = 1; before, s grows without end
  const Lens lens(spec_of("rational_polynomial", {0, 0, 0, 0, 0, -1, 0, 0}));
  EXPECT_NEAR(lens.widest_angle(), pi / 4, 1e-8);
  EXPECT_FALSE(lens.project({1.1, 0, 1}));
  EXPECT_TRUE(lens.ray({639, 479}));
}

/// Wild numbers: most of these lenses fold inside the picture.
LensSpec random_spec(int i, const RandomStream& random, std::uint64_t& n) {
  const auto number = [&](double size) { return random.uniform(n++, -size, size); };
  switch (i % 4) {
    case 0: return spec_of("plumb_bob", {number(1), number(1), number(0.05), number(0.05), number(0.5)});
    case 1:
      return spec_of("rational_polynomial", {number(1), number(1), number(0.05), number(0.05), number(0.5), number(1),
                                             number(1), number(0.5)});
    case 2: return spec_of("equidistant", {number(0.5), number(0.3), number(0.2), number(0.1)});
    default:
      return spec_of("ray_polynomial", {1 + number(0.9), number(1), number(1), number(1), number(0.5), number(0.5)});
  }
}

TEST(Lens, WithAnyCoefficientsIsOneToOneWithinItsFold) {
  const RandomStream random(5, "lenses");
  std::uint64_t n = 0;
  int seen = 0, unseen = 0;
  for (int i = 0; i < 400; ++i) {
    const LensSpec spec = random_spec(i, random, n);
    const Lens lens(spec);
    for (int j = 0; j < 100; ++j) {
      // not within a part in a million of the fold, where rays hang on the last digits of pixels
      const double angle = (1 - 1e-6) * lens.widest_angle() * random.uniform(n),
                   turn = random.uniform(n + 1, 0, 2 * pi);
      n += 2;
      const Vec3d ray{std::sin(angle) * std::cos(turn), std::sin(angle) * std::sin(turn), std::cos(angle)};
      const auto pixel = lens.project(ray);
      ASSERT_TRUE(pixel) << spec.model;
      const auto again = lens.ray(*pixel);
      // far out of the picture of a lens of the plane, where pixels hang on the last digits of rays
      if (!again && std::hypot(pixel->u, pixel->v) > 1e6) continue;
      ASSERT_TRUE(again) << spec.model << ' ' << fmt::format("{}", fmt::join(spec.coefficients, " ")) << ' ' << angle;
      ASSERT_LT(angle_between(ray, *again), 1e-5) << spec.model << ' ' << angle << ' ' << lens.widest_angle();
      const Pixel any{random.uniform(n, 0, 640), random.uniform(n + 1, 0, 480)};
      n += 2;
      const auto look = lens.ray(any);
      ++(look ? seen : unseen);
      const auto back = look ? lens.project(*look) : any;
      ASSERT_TRUE(back) << spec.model;
      ASSERT_LT(std::hypot(back->u - any.u, back->v - any.v), 1e-6) << spec.model;
    }
  }
  EXPECT_GT(seen, 10000);
  EXPECT_GT(unseen, 5000);
}

TEST(Lens, KnowsHowFarItsPictureReaches) {
  LensSpec spec{.width = 200, .height = 100, .fx = 100, .fy = 100, .cx = 99.5, .cy = 49.5};
  const Fov fov = Lens(spec).fov();
  EXPECT_NEAR(fov.horizontal, pi / 2, 1e-12);
  EXPECT_NEAR(fov.vertical, 2 * std::atan(0.5), 1e-12);
  EXPECT_NEAR(fov.diagonal, 2 * std::atan(std::sqrt(1.25)), 1e-12);
  EXPECT_NEAR(Lens(spec).corner_angle(), std::atan(std::sqrt(1.25)), 1e-12);
  EXPECT_EQ(Lens(spec).fold_warning(), "");
}

TEST(Lens, RefusesNumbersThatAreNoLens) {
  const auto with = [](auto change) {
    LensSpec spec = spec_of("perspective", {});
    change(spec);
    return message(spec);
  };
  EXPECT_EQ(with([](LensSpec& s) { s.fx = 0; }), "the focal length fx is 0; it must be above 0, in pixels");
  EXPECT_EQ(with([](LensSpec& s) { s.fy = -3; }), "the focal length fy is -3; it must be above 0, in pixels");
  EXPECT_EQ(with([](LensSpec& s) { s.fy = std::nan(""); }),
            "the focal length fy is nan; it must be above 0, in pixels");
  EXPECT_EQ(with([](LensSpec& s) { s.width = 0; }), "the picture's width is 0; it must be 1 to 8192 pixels");
  EXPECT_EQ(with([](LensSpec& s) { s.height = 100000; }),
            "the picture's height is 100000; it must be 1 to 8192 pixels");
  EXPECT_EQ(with([](LensSpec& s) { s.cx = 2000; }), "the center cx is 2000; it must be -640 to 1280, in pixels");
  EXPECT_EQ(with([](LensSpec& s) { s.model = "equidistent"; }),
            "unknown lens model 'equidistent'; did you mean 'equidistant'?");
  EXPECT_EQ(message(spec_of("plumb_bob", {1, 2, 3})),
            "'plumb_bob' has 3 coefficients; it needs 4 to 5: k1 k2 p1 p2 and perhaps k3");
  EXPECT_EQ(message(spec_of("rational_polynomial", {1, 2, 3, 4, 5})),
            "'rational_polynomial' has 5 coefficients; it needs 8: k1 k2 p1 p2 k3 k4 k5 k6");
  EXPECT_EQ(message(spec_of("equidistant", {0.1, std::nan("")})),
            "coefficient 2 of 'equidistant' is nan; it must be a finite number");
  EXPECT_EQ(message(spec_of("ray_polynomial", {-1})), "coefficient a1 of 'ray_polynomial' is -1; it must be above 0");
}

}  // namespace
}  // namespace murosimf::imaging
