// A camera's numbers as files say them: defaults, lenses and their coefficients, focal length of an angle, bounds.
#include "murosimf/sensors/camera_spec.h"

#include <gtest/gtest.h>

#include "murosimf/model/error.h"
#include "tests/fixtures.h"

namespace murosimf::sensors {
namespace {

using fixtures::error_of;
using fixtures::says;
using Numbers = std::map<std::string, double>;

CameraSpec of(const Numbers& numbers, const std::map<std::string, std::string>& texts = {}) {
  return camera_spec({.numbers = numbers, .texts = texts});
}

TEST(CameraSpec, OfAPlainCameraIfNothingIsSaid) {
  const CameraSpec camera = of({});
  EXPECT_EQ(camera.lens.model, "perspective");
  EXPECT_EQ(camera.lens.width, 640);
  EXPECT_EQ(camera.lens.height, 480);
  EXPECT_EQ(camera.lens.cx, 319.5);
  EXPECT_EQ(camera.lens.cy, 239.5);
  EXPECT_NEAR(camera.lens.fx, 320 / std::tan(pi / 6), 1e-9) << "60 degrees from side to side";
  EXPECT_EQ(camera.lens.fy, camera.lens.fx);
  EXPECT_TRUE(camera.layers.color);
  EXPECT_FALSE(camera.layers.depth || camera.layers.labels || camera.always_on);
  EXPECT_EQ(camera.resolution, 1);
  EXPECT_EQ(camera.exposure, 1);
  EXPECT_EQ(camera.motion_samples, 8);
  EXPECT_EQ(camera.readout_bands, 24);
  EXPECT_EQ(camera.blur + camera.exposure_time + camera.readout_time + camera.shot_noise + camera.read_noise, 0);
  EXPECT_EQ(camera.mosaic, "");
}

TEST(CameraSpec, EveryNumberHasItsPlace) {
  const CameraSpec camera = of({{"width", 40},
                                {"height", 30},
                                {"cx", 18},
                                {"cy", 13},
                                {"fx", 50},
                                {"fy", 52},
                                {"always_on", 1},
                                {"depth", 1},
                                {"labels", 1},
                                {"color", 0},
                                {"resolution", 2},
                                {"blur", 3},
                                {"exposure", 4},
                                {"exposure_time", 0.5},
                                {"motion_samples", 6},
                                {"readout_time", 0.7},
                                {"readout_bands", 5},
                                {"shot_noise", 0.08},
                                {"read_noise", 0.09}},
                               {{"mosaic", "rggb"}});
  EXPECT_EQ(camera.lens.width, 40);
  EXPECT_EQ(camera.lens.height, 30);
  EXPECT_EQ(camera.lens.cx, 18);
  EXPECT_EQ(camera.lens.cy, 13);
  EXPECT_EQ(camera.lens.fx, 50);
  EXPECT_EQ(camera.lens.fy, 52);
  EXPECT_TRUE(camera.layers.depth && camera.layers.labels && camera.always_on);
  EXPECT_FALSE(camera.layers.color);
  EXPECT_EQ(camera.resolution, 2);
  EXPECT_EQ(camera.blur, 3);
  EXPECT_EQ(camera.exposure, 4);
  EXPECT_EQ(camera.exposure_time, 0.5);
  EXPECT_EQ(camera.motion_samples, 6);
  EXPECT_EQ(camera.readout_time, 0.7);
  EXPECT_EQ(camera.readout_bands, 5);
  EXPECT_EQ(camera.shot_noise, 0.08);
  EXPECT_EQ(camera.read_noise, 0.09);
  EXPECT_EQ(camera.mosaic, "rggb");
  for (const char* only : {"color", "depth", "labels"}) {
    Numbers numbers{{"color", 0}, {"depth", 0}, {"labels", 0}};
    numbers[only] = 1;
    EXPECT_NO_THROW((void)of(numbers)) << only;
  }
  EXPECT_EQ(of({{"height", 10}}).readout_bands, 10) << "no more than rows";
}

// The model that is named counts; else what coefficients there are.
TEST(CameraSpec, CoefficientsTellTheLens) {
  EXPECT_EQ(of({{"k1", 0.1}}).lens.model, "plumb_bob");
  EXPECT_EQ(of({{"a1", 1}, {"fx", 50}}).lens.model, "ray_polynomial");
  EXPECT_EQ(of({{"k1", 0.1}}, {{"lens", "equidistant"}}).lens.model, "equidistant");
  EXPECT_EQ(of({{"k1", 0.1}, {"k3", 0.3}, {"p2", 0.02}}).lens.coefficients,
            (std::vector<double>{0.1, 0, 0, 0.02, 0.3}));
  EXPECT_EQ(of({{"k2", 0.2}}, {{"lens", "equidistant"}}).lens.coefficients, (std::vector<double>{0, 0.2, 0, 0}));
  EXPECT_EQ(of({{"k1", 0.01}, {"k6", 0.06}}, {{"lens", "rational_polynomial"}}).lens.coefficients,
            (std::vector<double>{0.01, 0, 0, 0, 0, 0, 0, 0.06}));
  EXPECT_EQ(of({{"a1", 1}, {"a6", 0.06}, {"fx", 50}}).lens.coefficients, (std::vector<double>{1, 0, 0, 0, 0, 0.06}));
  EXPECT_TRUE(says(error_of([] {
                     (void)of({{"k4", 0.1}, {"k1", 0.1}});
                   }),
                   {"'k4' is no coefficient of the lens model 'plumb_bob'", "k1, k2, p1, p2, k3"}));
  EXPECT_TRUE(says(error_of([] { (void)of({{"k1", 0.1}}, {{"lens", "perspective"}}); }), {"'k1'", "it has none"}));
}

// The border of the picture is seen at half of the angle.
TEST(CameraSpec, FocalLengthFollowsFromTheAngle) {
  EXPECT_NEAR(of({{"fov", 2.0}, {"width", 100}}).lens.fx, 50 / std::tan(1.0), 1e-9);
  EXPECT_NEAR(of({{"fov", 2.0}, {"width", 100}}, {{"lens", "equidistant"}}).lens.fx, 50, 1e-9) << "pixels by the angle";
  EXPECT_EQ(of({{"fov", 2.0}, {"fx", 77}}).lens.fx, 77);
  EXPECT_EQ(of({{"fov", 2.0}, {"fx", 77}}).lens.fy, 77);
  EXPECT_TRUE(says(error_of([] { (void)of({{"fov", 3.2}}); }), {"a perspective lens cannot see 3.2 rad"}));
}

TEST(CameraSpec, NumbersHaveBounds) {
  const std::map<std::string, std::pair<double, double>> ends{{"width", {1, 8192}},      {"height", {1, 8192}},
                                                              {"resolution", {0.1, 4}},  {"blur", {0, 50}},
                                                              {"exposure_time", {0, 1}}, {"motion_samples", {1, 64}},
                                                              {"readout_time", {0, 1}},  {"readout_bands", {1, 8192}},
                                                              {"shot_noise", {0, 1}},    {"read_noise", {0, 1}}};
  for (const auto& [key, bounds] : ends) {
    const auto error = [&wanted = key](double number) {
      return error_of([&] { (void)of({{wanted, number}, {"fx", 50}}); });
    };
    EXPECT_EQ(error(bounds.first), "no error") << key;
    EXPECT_EQ(error(bounds.second), "no error") << key;
    EXPECT_TRUE(says(error(bounds.first - 1), {key})) << key;
    EXPECT_TRUE(says(error(bounds.second + 1), {key})) << key;
  }
}

}  // namespace
}  // namespace murosimf::sensors
