// Errors where symmetric tests are blind: biased axes that are misaligned, the first sample of noise, turned robots.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/sensors/detector.h"
#include "murosimf/sensors/frame_sensors.h"
#include "murosimf/sensors/inertial.h"
#include "murosimf/sensors/signal.h"
#include "tests/fixtures.h"
#include "tests/physics/rig.h"
#include "tests/sensors/puppet.h"
#include "tests/sensors/range_rig.h"

namespace murosimf::sensors {
namespace {

const std::vector<std::string> three{"robot/sensor/x", "robot/sensor/y", "robot/sensor/z"};

std::array<double, 3> disturbed(const SignalSpec& spec, std::array<double, 3> values) {
  Signal signal(spec, 1, three, {});
  signal.disturb(values);
  return values;
}

// x1 = x + misalignment * (the other two true values) + bias: the same streams, so both errors add up.
TEST(SignalErrors, MisalignmentIsOfTrueValues) {
  const std::array<double, 3> x{1, -2, 5};
  const auto turned = disturbed({.misalignment = 0.3}, x), shifted = disturbed({.bias = 4}, {0, 0, 0});
  const auto both = disturbed({.misalignment = 0.3, .bias = 4}, x);
  const auto scaled = disturbed({.scale_error = 0.2, .misalignment = 0.3}, x),
             longer = disturbed({.scale_error = 0.2}, x);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(both[i], turned[i] + shifted[i], 1e-12) << i;
    EXPECT_NEAR(scaled[i], longer[i] + turned[i] - x[i], 1e-12) << i;
    EXPECT_GT(std::abs(shifted[i]), 0.01);
  }
}

// Each axis with its two neighbors by coefficients of its own.
TEST(SignalErrors, MisalignmentIsLinearInTheOtherAxes) {
  const SignalSpec spec{.misalignment = 0.3};
  std::array<std::array<double, 3>, 3> columns{};
  for (std::size_t j = 0; j < 3; ++j) {
    std::array<double, 3> unit{};
    unit[j] = 1;
    columns[j] = disturbed(spec, unit);
    EXPECT_EQ(columns[j][j], 1);
  }
  const auto all = disturbed(spec, {1, -2, 5});
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(all[i], columns[0][i] - 2 * columns[1][i] + 5 * columns[2][i], 1e-12);
    EXPECT_NE(columns[(i + 1) % 3][i], columns[(i + 2) % 3][i]);
    EXPECT_NE(columns[(i + 1) % 3][i], 0);
  }
}

// Over many sensors: each axis is turned towards either of its neighbors by numbers of the deviation `misalignment`.
TEST(SignalErrors, MisalignmentHasItsDeviation) {
  constexpr int count = 4000;
  for (std::size_t j = 0; j < 3; ++j) {
    std::array<double, 3> squares{};
    for (int k = 0; k < count; ++k) {
      Signal signal({.misalignment = 0.02}, 1,
                    {fmt::format("robot/{}/x", k), fmt::format("robot/{}/y", k), fmt::format("robot/{}/z", k)}, {});
      std::array<double, 3> values{};
      values[j] = 5;
      signal.disturb(values);
      for (std::size_t i = 0; i < 3; ++i) squares[i] += (values[i] - (i == j ? 5 : 0)) * (values[i] - (i == j ? 5 : 0));
    }
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(std::sqrt(squares[i] / count), i == j ? 0 : 5 * 0.02, 0.005) << i << " of " << j;
    }
  }
}

// Noise behind a low-pass is stationary from its first sample on: (1 - a) N / sqrt(T) / sqrt(1 - a^2).
TEST(SignalErrors, NoiseBehindALowPassIsStationaryFromTheFirstSample) {
  const double T = 0.002, N = 0.5, corner = 10, a = std::exp(-2 * pi * corner * T);
  const double expected = (1 - a) * N / std::sqrt(T) / std::sqrt(1 - a * a);
  constexpr int count = 4000;
  double first = 0, tenth = 0, product = 0;
  for (int i = 0; i < count; ++i) {
    Signal signal({.noise_density = N, .low_pass = corner}, 1, {fmt::format("robot/sensor/{}", i)}, {T, T});
    signal.start();
    std::array<double, 10> shown{};
    for (double& value : shown) signal.convert({&value, 1});
    first += shown[0] * shown[0] / count;
    tenth += shown[9] * shown[9] / count;
    product += shown[0] * shown[1] / count;
  }
  EXPECT_NEAR(std::sqrt(first) / expected, 1, 0.04);
  EXPECT_NEAR(std::sqrt(tenth) / expected, 1, 0.04);
  EXPECT_NEAR(product / first, a, 0.03) << "neighbors in time are correlated by a";
}

Quaterniond shown_orientation(const Mat3d& truth) {
  SensorSpec spec{.name = "o"};
  spec.signals["orientation"] = {.bias = 0.2};
  test::SensorRig<Orientation> rig([=](double) { return test::BodyMotion{.orientation = truth}; }, spec);
  rig.run_until(0.01);
  const auto q = rig.reading().output("orientation");
  return {q[0], q[1], q[2], q[3]};
}

// The error turns the sensor in its own axes: the same turn between the truth and what is shown, however the robot lies.
TEST(OrientationErrors, AreOfTheSensorsAxes) {
  const Mat3d error = to_matrix(shown_orientation({}));
  EXPECT_GT(norm(rotation_vector(from_matrix(error))), 0.05);
  for (const Mat3d& truth : {rotation_x(1.2), rotation_z(-2) * rotation_y(0.8)}) {
    EXPECT_LT(fixtures::difference(to_matrix(shown_orientation(truth)), truth * error), 1e-12);
  }
}

// Errors of the three numbers of a sighting are independent of each other.
TEST(DetectorErrors, AreIndependent) {
  test::RangeRig rig;
  Entity& robot = rig.add_box("robot");
  Entity& ball = rig.add_ball("ball");
  const Reading& reading =
      rig.attach(robot, test::sensor("detector",
                                     {{"distance_noise", 0.05}, {"azimuth_noise", 0.02}, {"elevation_noise", 0.03}}));
  rig.begin();
  test::RangeRig::put(robot, {0, 0, 5});
  test::RangeRig::put(ball, {2, 0.5, 5.2});
  std::array<std::array<double, 3>, 3> products{};
  const std::array<double, 3> truth{std::sqrt(4 + 0.25 + 0.04), std::atan2(0.5, 2), std::atan2(0.2, std::sqrt(4.25))};
  constexpr int looks = 3000;
  for (int k = 0; k < looks; ++k) {
    rig.simulation.step();
    const auto shown = reading.output("ball");
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) products[i][j] += (shown[i] - truth[i]) * (shown[j] - truth[j]) / looks;
    }
  }
  EXPECT_NEAR(std::sqrt(products[0][0]) / truth[0], 0.05, 0.004);
  EXPECT_NEAR(std::sqrt(products[1][1]), 0.02, 0.002);
  EXPECT_NEAR(std::sqrt(products[2][2]), 0.03, 0.003);
  for (const auto& [i, j] : {std::pair{0, 1}, {0, 2}, {1, 2}}) {
    EXPECT_LT(std::abs(products[i][j]) / std::sqrt(products[i][i] * products[j][j]), 0.08) << i << " " << j;
  }
}

// The common center of mass of a robot that turns, flies and moves a limb; what the level says is worked out elsewhere.
TEST(CenterOfMassSensor, ShowsThatOfAllLinks) {
  test::Rig rig;
  Entity& robot = rig.add("robot", std::make_shared<const Model>(fixtures::two_legged()),
                          {.position = {1, -2, 3}, .heading = 0.7, .attitude = rotation_x(1.1)});
  auto& sensor =
      rig.simulation.attach<CenterOfMass>("sensor", robot, 1000, SensorSpec{.name = "c"}, SensorSurroundings{});
  rig.attach_dynamics(robot, {.level = "articulated_dynamics", .on_ground = false});
  rig.simulation.initialize();
  robot.object("left_hip_pitch").set(properties::joint_velocity, 5);
  test::Rig::launch(robot, {0.4, 0.6, 1}, {1, -2, 3});
  for (int i = 0; i < 50; ++i) {
    rig.simulation.step();
    const Vec3d center = robot.base().get(properties::common_center_of_mass);
    const Vec3d velocity = robot.base().get(properties::common_center_of_mass_velocity);
    rig.simulation.step();
    const auto place = sensor.reading().output("position"), speed = sensor.reading().output("velocity");
    EXPECT_LT(fixtures::difference({place[0], place[1], place[2]}, center), 1e-12);
    EXPECT_LT(fixtures::difference({speed[0], speed[1], speed[2]}, velocity), 1e-12);
  }
}

}  // namespace
}  // namespace murosimf::sensors
