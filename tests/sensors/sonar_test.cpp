// Sonar and range finder against closed forms.
#include "murosimf/sensors/sonar.h"

#include <gtest/gtest.h>

#include "tests/sensors/range_rig.h"

namespace murosimf::sensors {
namespace {

using fixtures::placed;
using fixtures::says;
using test::infinity;
using test::RangeRig;

constexpr double degree = pi / 180;

/// What a sonar of 2000 rays and 30 degrees shows of a ball of 5 cm, 2 m away, at an angle from its axis.
double range_of_ball(double angle) {
  RangeRig rig;
  Entity& robot = rig.add_box("robot");
  Entity& ball = rig.add_ball("ball", 0.05);
  const Reading& reading = rig.attach(robot, test::sensor("sonar", {{"rays", 2000}, {"fov", 30 * degree}}));
  rig.begin();
  RangeRig::put(robot, {0, 0, 9}, rotation_z(1));
  RangeRig::put(ball, Vec3d{0, 0, 9} + rotation_z(1) * rotation_y(-angle) * Vec3d{2, 0, 0});
  rig.simulation.step();
  return reading.values[0];
}

TEST(Sonar, ShowsTheNearestThingInItsCone) {
  const double half_ball = std::asin(0.05 / 2);
  EXPECT_NEAR(range_of_ball(0), 1.95, 1e-12);
  for (const double angle : {5 * degree, 10 * degree, 14 * degree}) EXPECT_NEAR(range_of_ball(angle), 1.95, 0.005);
  EXPECT_NEAR(range_of_ball(15 * degree + 0.8 * half_ball), 2, 0.05);
  EXPECT_EQ(range_of_ball(15 * degree + 1.01 * half_ball), infinity);
}

// Each ray by itself: a ball of 5 mm in its way, in the direction that sonar.h says.
TEST(Sonar, RaysWindAboutTheAxisAsSunflowersDo) {
  constexpr int rays = 9;
  constexpr double fov = 60 * degree, golden_angle = 2.399963229728653;
  RangeRig rig;
  Entity& robot = rig.add_box("robot");
  Entity& ball = rig.add_ball("ball", 0.005);
  const Reading& reading = rig.attach(robot, test::sensor("sonar", {{"rays", rays}, {"fov", fov}}));
  rig.begin();
  const Mat3d turn = rotation_z(1) * rotation_y(0.4);
  RangeRig::put(robot, {0, 0, 9}, turn);
  for (int k = 0; k < rays; ++k) {
    const double a = std::acos(1 - (1 - std::cos(fov / 2)) * k / (rays - 1));
    for (const double beside : {0.0, 0.5}) {
      RangeRig::put(ball,
                    Vec3d{0, 0, 9} + turn * rotation_x(golden_angle * k + beside) * rotation_z(a) * Vec3d{2, 0, 0});
      rig.simulation.step();
      if (beside > 0 && k > 0) {
        EXPECT_EQ(reading.values[0], infinity) << k;
      } else {
        EXPECT_NEAR(reading.values[0], 1.995, 1e-6) << k;
      }
    }
  }
  // where the spiral would go on there is none
  const double a = std::acos(1 - (1 - std::cos(fov / 2)) * rays / (rays - 1));
  RangeRig::put(ball, Vec3d{0, 0, 9} + turn * rotation_x(golden_angle * rays) * rotation_z(a) * Vec3d{2, 0, 0});
  rig.simulation.step();
  EXPECT_EQ(reading.values[0], infinity);
}

TEST(Sonar, DefaultsAreThoseOfItsHeader) {
  const auto range = [](const std::map<std::string, double>& numbers) {
    RangeRig rig;
    rig.add_walls({placed(Box{{0.1, 20, 20}})});
    Entity& robot = rig.add_box("robot");
    const Reading& reading = rig.attach(robot, test::sensor("sonar", numbers));
    rig.begin();
    RangeRig::put(robot, {-2.1, 0, 1}, rotation_z(0.3) * rotation_y(-0.7));
    rig.simulation.step();
    return reading.values[0];
  };
  EXPECT_EQ(range({}), range({{"rays", 61}, {"fov", 15 * degree}, {"range_min", 0.02}, {"range_max", 4}}));
  EXPECT_NE(range({}), range({{"rays", 60}}));
  EXPECT_NE(range({}), range({{"fov", 14.99 * degree}}));
}

// A wall that stands askew: the nearest ray is the one at the edge of the cone that leans towards it.
TEST(Sonar, FindsTheNearSideOfASkewWall) {
  RangeRig rig;
  rig.add_walls({placed(Box{{0.1, 20, 20}}, {0, 0, 0}, {})});
  Entity& robot = rig.add_box("robot");
  const Reading& reading = rig.attach(robot, test::sensor("sonar", {{"rays", 5000}, {"fov", 40 * degree}}));
  rig.begin();
  RangeRig::put(robot, {-2.1, 0, 1}, rotation_y(-45 * degree));
  rig.simulation.step();
  EXPECT_NEAR(reading.values[0], 2 / std::cos(25 * degree), 0.005);
  EXPECT_GE(reading.values[0], 2 / std::cos(25 * degree) - 1e-12);
}

TEST(Sonar, OutsideOfItsRangeItShowsInfinities) {
  RangeRig rig;
  Entity& robot = rig.add_box("robot");
  Entity& ball = rig.add_ball("ball");
  const Reading& reading = rig.attach(robot, test::sensor("sonar", {{"range_min", 0.25}, {"range_max", 2.55}}));
  rig.begin();
  RangeRig::put(robot, {0, 0, 1});
  const auto at = [&](double x) {
    RangeRig::put(ball, {x, 0, 1});
    rig.simulation.step();
    return reading.values[0];
  };
  EXPECT_EQ(at(0.34), -infinity);
  EXPECT_NEAR(at(0.36), 0.26, 1e-12);
  EXPECT_NEAR(at(2.64), 2.54, 1e-12);
  EXPECT_EQ(at(2.66), infinity);
}

// Rule: noise does not show distances that are out of range. A ball at either end, noise of 20 mm.
TEST(Sonar, NoiseBeyondItsRangeIsInfinite) {
  RangeRig rig;
  Entity& robot = rig.add_box("robot");
  Entity& ball = rig.add_ball("ball");
  SensorSpec spec = test::sensor("sonar", {{"range_min", 0.25}, {"range_max", 2.5}});
  spec.signals["range"] = {.noise = 0.02};
  const Reading& reading = rig.attach(robot, spec);
  rig.begin();
  RangeRig::put(robot, {0, 0, 1});
  for (const auto& [distance, beyond] : {std::pair{2.49, infinity}, {0.26, -infinity}}) {
    RangeRig::put(ball, {distance + 0.1, 0, 1});
    int out = 0;
    double squares = 0;
    for (int i = 0; i < 400; ++i) {
      rig.simulation.step();
      const double shown = reading.values[0];
      if (std::isinf(shown)) {
        EXPECT_EQ(shown, beyond);
        ++out;
        continue;
      }
      EXPECT_GE(shown, 0.25);
      EXPECT_LE(shown, 2.5);
      squares += (shown - distance) * (shown - distance);
    }
    // half a deviation from the end: 31 % of normal numbers are beyond
    EXPECT_NEAR(out, 0.31 * 400, 40) << distance;
    EXPECT_GT(squares, 0);
  }
}

// Above the ground, tilted.
TEST(RangeFinder, MeasuresAlongZ) {
  RangeRig rig;
  Entity& robot = rig.add_box("robot");
  SensorSpec spec = test::sensor("rangefinder");
  spec.orientation = rotation_y(pi);
  spec.position = {0.1, 0, 0};
  const Reading& reading = rig.attach(robot, spec);
  rig.begin();
  const double tilt = 0.3;
  RangeRig::put(robot, {0, 0, 1}, rotation_y(tilt));
  rig.simulation.step();
  EXPECT_NEAR(reading.values[0], (1 - 0.1 * std::sin(tilt)) / std::cos(tilt), 1e-12);
  RangeRig::put(robot, {0, 0, 1}, rotation_y(2));
  rig.simulation.step();
  EXPECT_EQ(reading.values[0], infinity);
}

TEST(Sonar, ImpossibleNumbersAreNamed) {
  EXPECT_TRUE(says(test::error(test::sensor("sonar", {{"rays", 0}})), {"'rays' is 0"}));
  EXPECT_TRUE(says(test::error(test::sensor("sonar", {{"rays", 100001}})), {"'rays' is 100001"}));
  EXPECT_EQ(test::error(test::sensor("sonar", {{"rays", 1}})), "no error");
  EXPECT_EQ(test::error(test::sensor("sonar", {{"rays", 100000}})), "no error");
  EXPECT_TRUE(says(test::error(test::sensor("sonar", {{"fov", 7}})), {"'fov' is 7"}));
  EXPECT_TRUE(says(test::error(test::sensor("rangefinder", {{"range_max", 0}})), {"range_max 0"}));
}

}  // namespace
}  // namespace murosimf::sensors
