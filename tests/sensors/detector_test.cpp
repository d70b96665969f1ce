// The detector of ball and robots: geometry, field of view, what is hidden, misses and errors.
#include "murosimf/sensors/detector.h"

#include <gtest/gtest.h>

#include "tests/law.h"
#include "tests/sensors/range_rig.h"

namespace murosimf::sensors {
namespace {

using fixtures::Dice;
using fixtures::placed;
using fixtures::says;
using test::infinity;
using test::RangeRig;

constexpr double degree = pi / 180;

/// A place in axes of the sensor.
Vec3d at_angles(double distance, double azimuth, double elevation) {
  return rotation_z(azimuth) * rotation_y(-elevation) * Vec3d{distance, 0, 0};
}

/// The values "distance, azimuth, elevation" put together again.
Vec3d place_of(const Reading& reading, const std::string& entity) {
  const auto values = reading.output(entity);
  return at_angles(values[0], values[1], values[2]);
}

bool sees(const Reading& reading, const std::string& entity) {
  const auto values = reading.output(entity);
  EXPECT_EQ(std::isnan(values[0]), std::isnan(values[1]));
  EXPECT_EQ(std::isnan(values[0]), std::isnan(values[2]));
  return !std::isnan(values[0]);
}

const std::map<std::string, double> looks_everywhere{{"fov_azimuth", 2 * pi}, {"fov_elevation", pi}};

TEST(Detector, ShowsWhereThingsAre) {
  Dice dice("detector");
  RangeRig rig;
  Entity& robot = rig.add_box("robot");
  Entity& ball = rig.add_ball("ball");
  Entity& other = rig.add_box("other");
  SensorSpec spec = test::sensor("detector", looks_everywhere);
  spec.position = {0.1, -0.2, 0.3};
  spec.orientation = dice.turn();
  const Reading& reading = rig.attach(robot, spec);
  rig.begin();
  ASSERT_EQ(reading.info->outputs.size(), 2u);
  EXPECT_EQ(reading.info->outputs[0].labels, (std::vector<std::string>{"distance", "azimuth", "elevation"}));
  law::Worst worst;
  for (int i = 0; i < 200; ++i) {
    const Mat3d R = dice.turn();
    const Vec3d eye = Vec3d{0, 0, 10} + R * spec.position;
    RangeRig::put(robot, {0, 0, 10}, R);
    const Vec3d way = dice.unit();
    const double distance = dice.uniform(1, 8);
    RangeRig::put(ball,
                  Vec3d{0, 0, 10} + distance * Vec3d{-std::abs(way.x), way.y, way.z});  // not before the other one
    RangeRig::put(other, Vec3d{20, 0, 10} + dice.vector(3));
    rig.simulation.step();
    for (Entity* seen : {&ball, &other}) {
      const Vec3d place = R * (spec.orientation * place_of(reading, seen->name()));
      worst.see(norm(place - (RangeRig::place(*seen) - eye)), seen->name(), i);
    }
  }
  law::expect_below({.law = "detector without errors: error of the place that it shows",
                     .level = "simplified_dynamics",
                     .source = "difference of the true places, in axes of the sensor"},
                    worst, 1e-12, "m");
}

TEST(Detector, LeftAndUpArePositive) {
  RangeRig rig;
  Entity& robot = rig.add_box("robot");
  Entity& ball = rig.add_ball("ball");
  const Reading& reading = rig.attach(robot, test::sensor("detector"));
  rig.begin();
  RangeRig::put(robot, {0, 0, 5});
  RangeRig::put(ball, {2, 2, 5 + std::sqrt(8.0) * std::tan(0.2)});
  rig.simulation.step();
  EXPECT_NEAR(reading.output("ball")[0], std::sqrt(8.0) / std::cos(0.2), 1e-12);
  EXPECT_NEAR(reading.output("ball")[1], pi / 4, 1e-12);
  EXPECT_NEAR(reading.output("ball")[2], 0.2, 1e-12);
}

TEST(Detector, FieldOfViewAndRangeEndWhereTheyShould) {
  RangeRig rig;
  Entity& robot = rig.add_box("robot");
  Entity& ball = rig.add_ball("ball", 0.01);
  const Reading& reading =
      rig.attach(robot,
                 test::sensor("detector",
                              {{"fov_azimuth", 100 * degree}, {"fov_elevation", 60 * degree}, {"range_max", 6}}));
  rig.begin();
  RangeRig::put(robot, {0, 0, 10});
  const auto sees_at = [&](double distance, double azimuth, double elevation) {
    RangeRig::put(ball, Vec3d{0, 0, 10} + at_angles(distance, azimuth * degree, elevation * degree));
    rig.simulation.step();
    return sees(reading, "ball");
  };
  constexpr double little = 1e-6;
  for (const double side : {-1, 1}) {
    EXPECT_TRUE(sees_at(3, side * (50 - little), 0));
    EXPECT_FALSE(sees_at(3, side * (50 + little), 0));
    EXPECT_FALSE(sees_at(3, side * 179, 0));
    EXPECT_TRUE(sees_at(3, 0, side * (30 - little)));
    EXPECT_FALSE(sees_at(3, 0, side * (30 + little)));
    EXPECT_TRUE(sees_at(3, side * (50 - little), side * (30 - little)));
  }
  EXPECT_TRUE(sees_at(6 - little, 10, 0));
  EXPECT_FALSE(sees_at(6 + little, 10, 0));
  EXPECT_TRUE(sees_at(0.1 + little, 10, 0));
  EXPECT_FALSE(sees_at(0.1 - little, 10, 0));
}

/// A ball at x = 4 behind another robot at x = 2 that stands `aside` [m].
bool sees_ball_behind_robot(double aside, double visible_share = 0.25) {
  RangeRig rig;
  Entity& robot = rig.add_box("robot");
  Entity& other = rig.add_box("other");
  Entity& ball = rig.add_ball("ball", 0.05);
  const Reading& reading = rig.attach(robot, test::sensor("detector", {{"visible_share", visible_share}}));
  rig.begin();
  RangeRig::put(robot, {0, 0, 1});
  RangeRig::put(other, {2, aside, 1});
  RangeRig::put(ball, {4, 0, 1});
  rig.simulation.step();
  EXPECT_TRUE(sees(reading, "other"));
  return sees(reading, "ball");
}

// The robot covers 0.1 m to each side: 0.2 m where the ball is.
TEST(Detector, ARobotHidesWhatIsBehindIt) {
  EXPECT_FALSE(sees_ball_behind_robot(0));
  EXPECT_FALSE(sees_ball_behind_robot(0.07));
  EXPECT_TRUE(sees_ball_behind_robot(0.13));
  EXPECT_TRUE(sees_ball_behind_robot(0.11, 0.6));
  EXPECT_FALSE(sees_ball_behind_robot(0.11, 0.9));
  EXPECT_FALSE(sees_ball_behind_robot(0, 0));
}

TEST(Detector, WallsHideToo) {
  RangeRig rig;
  rig.add_walls({placed(Box{{0.05, 1, 1}}, {2, 0, 1})});
  Entity& robot = rig.add_box("robot");
  Entity& ball = rig.add_ball("ball");
  const Reading& reading = rig.attach(robot, test::sensor("detector"));
  rig.begin();
  RangeRig::put(robot, {0, 0, 1});
  RangeRig::put(ball, {4, 0, 1});
  rig.simulation.step();
  EXPECT_FALSE(sees(reading, "ball"));
  RangeRig::put(ball, {4, 0, 4});
  rig.simulation.step();
  EXPECT_TRUE(sees(reading, "ball"));
}

// A robot walks through the line of sight, and on.
TEST(Detector, WhatMovesHidesWhereItIsNow) {
  RangeRig rig;
  Entity& robot = rig.add_box("robot");
  Entity& other = rig.add_box("other");
  Entity& ball = rig.add_ball("ball", 0.05);
  const Reading& reading = rig.attach(robot, test::sensor("detector"));
  rig.begin();
  RangeRig::put(robot, {0, 0, 1});
  RangeRig::put(ball, {4, 0, 1});
  for (const double aside : {1.0, 0.5, 0.0, -0.5, -1.0}) {
    RangeRig::put(other, {2, aside, 1});
    rig.simulation.step();
    EXPECT_EQ(sees(reading, "ball"), aside != 0) << aside;
  }
}

/// Errors of many looks at a ball that hangs still.
struct Statistics {
  Statistics(const std::map<std::string, double>& numbers, int looks) {
    RangeRig rig;
    Entity& robot = rig.add_box("robot");
    Entity& ball = rig.add_ball("ball");
    const Reading& reading = rig.attach(robot, test::sensor("detector", numbers));
    rig.begin();
    RangeRig::put(robot, {0, 0, 5});
    RangeRig::put(ball, Vec3d{0, 0, 5} + at_angles(3, 0.3, -0.2));
    const std::array<double, 3> truth{3, 0.3, -0.2};
    for (int i = 0; i < looks; ++i) {
      rig.simulation.step();
      if (!sees(reading, "ball")) continue;
      ++seen;
      for (std::size_t k = 0; k < 3; ++k) {
        const double error = reading.values[k] - truth[k];
        mean[k] += error;
        deviation[k] += error * error;
      }
    }
    for (std::size_t k = 0; k < 3; ++k) {
      mean[k] /= seen;
      deviation[k] = std::sqrt(std::max(deviation[k] / seen - mean[k] * mean[k], 0.0));
    }
  }
  int seen = 0;
  std::array<double, 3> mean{}, deviation{};
};

TEST(Detector, MissesAreAsOftenAsAsked) {
  constexpr int looks = 10000;
  const double misses = 0.15;
  const Statistics result({{"misses", misses}}, looks);
  law::expect_near({.law = "detector: missed detections of 10000",
                    .level = "simplified_dynamics",
                    .source = "binomial distribution, four deviations"},
                   looks - result.seen, misses * looks, 4 * std::sqrt(looks * misses * (1 - misses)), "1");
  EXPECT_EQ(Statistics({{"misses", 1}}, 10).seen, 0);
  EXPECT_EQ(Statistics({{"misses", 0}}, 10).seen, 10);
}

// A deviation estimated from n samples has a relative deviation of its own of 1 / sqrt(2 n): here 0.7 %.
TEST(Detector, ErrorsHaveTheirDeviations) {
  constexpr int looks = 10000;
  const Statistics result({{"distance_noise", 0.01}, {"azimuth_noise", 0.02}, {"elevation_noise", 0.005}}, looks);
  const std::array<double, 3> expected{3 * 0.01, 0.02, 0.005};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(result.deviation[k], expected[k], 0.03 * expected[k]) << k;
    EXPECT_NEAR(result.mean[k], 0, 4 * expected[k] / 100) << k;
  }
}

TEST(Detector, TheOffsetIsConstantAndWithinItsBounds) {
  const Statistics result({{"offset", 0.05}}, 50);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_LT(result.deviation[k], 1e-7);
    EXPECT_NE(result.mean[k], 0);
  }
  const Vec3d shown = at_angles(3 + result.mean[0], 0.3 + result.mean[1], -0.2 + result.mean[2]);
  const Vec3d offset = shown - at_angles(3, 0.3, -0.2);
  for (const double component : {offset.x, offset.y, offset.z}) EXPECT_LE(std::fabs(component), 0.05);
  EXPECT_GT(norm(offset), 0.005);
}

/// What a robot with noisy sensors shows of the ball and in its scan, with another robot far behind it or without.
std::uint64_t hash_of_appearance(bool with_another) {
  RangeRig rig;
  Entity& robot = rig.add_box("robot");
  Entity* another = with_another ? &rig.add_box("another") : nullptr;
  Entity& ball = rig.add_ball("ball");
  const Reading& detector =
      rig.attach(robot,
                 test::sensor("detector",
                              {{"misses", 0.3}, {"distance_noise", 0.1}, {"azimuth_noise", 0.1}, {"offset", 0.1}}));
  SensorSpec laser = test::sensor("laser", {{"fov", pi}});
  laser.signals[""].noise = 0.01;
  const Reading& scan = rig.attach(robot, laser);
  rig.begin();
  RangeRig::put(robot, {0, 0, 1});
  RangeRig::put(ball, {3, 0, 1});
  if (another) RangeRig::put(*another, {-5, 0, 1});
  Hasher hasher;
  for (int i = 0; i < 100; ++i) {
    rig.simulation.step();
    for (const double value : detector.output("ball")) hasher.add(std::isnan(value) ? -1 : value);
    for (const double value : scan.values) hasher.add(value);
  }
  return hasher.value();
}

TEST(Detector, ARobotOutOfSightChangesNoNoise) { EXPECT_EQ(hash_of_appearance(true), hash_of_appearance(false)); }

/// On the head of a robot that stands, at any level.
class RangeSensors : public testing::TestWithParam<std::string> {};

TEST_P(RangeSensors, WorkAtEveryLevel) {
  test::Rig rig;
  Entity& robot = rig.add("robot", test::kid21(), {.position = {0, 0, 0}});
  Entity& other = rig.add("other", test::kid21(), {.position = {2, 0.2, 0}, .heading = 1});
  const std::vector<Entity*> moving_entities{&robot, &other};
  const auto attach = [&](const std::string& type) {
    return &component_files::attach_sensor(rig.simulation, robot, test::sensor(type), {1, moving_entities}, rig.rate)
                .reading();
  };
  const Reading *detector = attach("detector"), *laser = attach("laser"), *sonar = attach("sonar");
  for (Entity* entity : moving_entities) rig.attach_motion(*entity, {.level = GetParam()});
  rig.run(0.01);
  const Vec3d way = test::Rig::place(other) - test::Rig::place(robot);
  EXPECT_NEAR(detector->output("other")[0], norm(way), 0.01);
  EXPECT_NEAR(detector->output("other")[1], std::atan2(way.y, way.x), 0.01);
  const double nearest = *std::min_element(laser->values.begin(), laser->values.end());
  EXPECT_GT(nearest, 1.5);
  EXPECT_LT(nearest, 2.1);
  EXPECT_GT(sonar->values[0], 1.5);
  EXPECT_LT(sonar->values[0], 2.1);
}

INSTANTIATE_TEST_SUITE_P(Levels, RangeSensors, testing::ValuesIn(test::all_levels()), test::level_name);

TEST(Detector, MistakesAreNamed) {
  const auto message = [](const char* key, double number) {
    return test::error(test::sensor("detector", {{key, number}}));
  };
  EXPECT_TRUE(says(message("misses", 1.1), {"detector: ", "'misses' is 1.1", "in the range 0 to 1"}));
  EXPECT_TRUE(says(message("distance_noise", -1), {"'distance_noise' is -1", "from 0"}));
  EXPECT_TRUE(says(message("azimuth_noise", std::nan("")), {"'azimuth_noise' is nan"}));
  EXPECT_TRUE(says(message("fov_azimuth", 6.3), {"'fov_azimuth' is 6.3"}));
  EXPECT_TRUE(says(message("fov_elevation", 3.2), {"'fov_elevation' is 3.2"}));
  EXPECT_TRUE(says(message("offset", -1), {"'offset' is -1"}));
  EXPECT_TRUE(says(message("range_min", infinity), {"'range_min' is inf"}));
  EXPECT_TRUE(says(message("visible_share", 2), {"'visible_share' is 2"}));
}

TEST(Detector, EntitiesMustExistAndBeOthers) {
  const auto message = [](const std::vector<std::string>& names) {
    SensorSpec spec = test::sensor("detector");
    spec.objects = names;
    return test::error(spec);
  };
  EXPECT_TRUE(says(message({"bal"}), {"unknown entity 'bal'", "'ball'"}));
  EXPECT_TRUE(says(message({"robot"}), {"'robot' carries the detector"}));
  EXPECT_EQ(message({"ball"}), "no error");
}

}  // namespace
}  // namespace murosimf::sensors
