// The laser range finder against closed forms.
#include "murosimf/sensors/laser.h"

#include <gtest/gtest.h>

#include "tests/law.h"
#include "tests/sensors/range_rig.h"

namespace murosimf::sensors {
namespace {

using fixtures::Dice;
using fixtures::placed;
using test::infinity;
using test::RangeRig;

/// A room of walls of 0.2 m around x from -3 to 4, y from -2 to 5, z from the ground to 2.5 m.
constexpr Vec3d room_low{-3, -2, 0}, room_high{4, 5, 2.5};

void build_room(RangeRig& rig) {
  const Vec3d middle = 0.5 * (room_low + room_high), half = 0.5 * (room_high - room_low) + Vec3d{0.2, 0.2, 0.2};
  rig.add_walls({placed(Box{{0.1, half.y, half.z}}, {room_low.x - 0.1, middle.y, middle.z}),
                 placed(Box{{0.1, half.y, half.z}}, {room_high.x + 0.1, middle.y, middle.z}),
                 placed(Box{{half.x, 0.1, half.z}}, {middle.x, room_low.y - 0.1, middle.z}),
                 placed(Box{{half.x, 0.1, half.z}}, {middle.x, room_high.y + 0.1, middle.z}),
                 placed(Box{{half.x, half.y, 0.1}}, {middle.x, middle.y, room_high.z + 0.1})});
}

/// To the wall that a ray from inside comes to.
double distance_in_room(const Vec3d& from, const Vec3d& along) {
  const auto to = [](double x, double d, double low, double high) {
    return d > 0 ? (high - x) / d : d < 0 ? (low - x) / d : infinity;
  };
  return std::min({to(from.x, along.x, room_low.x, room_high.x), to(from.y, along.y, room_low.y, room_high.y),
                   to(from.z, along.z, room_low.z, room_high.z)});
}

/// The largest error of a scan from `at`.
double worst_error(const Reading& reading, const Transformd& at) {
  double worst = 0;
  for (std::size_t i = 0; i < reading.values.size(); ++i) {
    const double angle = -0.75 * pi + static_cast<double>(i) * 1.5 * pi / 1080;
    const Vec3d along = at.orientation * Vec3d{std::cos(angle), std::sin(angle), 0};
    worst = fixtures::largest(worst, std::fabs(reading.values[i] - distance_in_room(at.position, along)));
  }
  return worst;
}

// A laser on a body that flies through a room and tumbles.
TEST(Laser, ScanOfABoxRoomIsExact) {
  Dice dice("laser in a room");
  RangeRig rig;
  build_room(rig);
  Entity& robot = rig.add_box("robot");
  SensorSpec spec = test::sensor("laser");
  spec.rate = 40;
  spec.position = {0.1, 0.02, 0.05};
  spec.orientation = dice.turn();
  const Reading& reading = rig.attach(robot, spec);
  rig.begin();
  RangeRig::put(robot, {0.3, 0.2, 1.1}, dice.turn());
  RangeRig::launch(robot, {0.4, 0.6, 0.1}, {1, 2, -1.5});
  law::Worst worst;
  for (std::uint64_t scan = 0; scan < 40;) {
    const Mat3d R = robot.base().get(properties::orientation);
    const Vec3d r = RangeRig::place(robot);
    rig.simulation.step();
    if (reading.samples == scan) continue;
    ++scan;
    ASSERT_EQ(reading.values.size(), 1081u);
    worst.see(worst_error(reading, {r + R * spec.position, R * spec.orientation}), "scan", scan);
  }
  EXPECT_EQ(reading.samples, 40u);
  EXPECT_EQ(rig.simulation.now(), from_seconds(39 * 0.025 + 0.001));
  law::expect_below({.law = "laser, 1081 rays at 40 Hz in a box room: error of any ray",
                     .level = "simplified_dynamics",
                     .source = "distance to the planes of the walls; the sensor flies and tumbles"},
                    worst, 1e-9, "m");
}

TEST(Laser, FirstRayPointsAtTheFirstAngleAndTheOthersFollowCounterclockwise) {
  RangeRig rig;
  Entity& robot = rig.add_box("robot");
  Entity& ball = rig.add_ball("ball");
  const Reading& reading =
      rig.attach(robot, test::sensor("laser", {{"rays", 4}, {"first_angle", 0}, {"fov", 1.5 * pi}}));
  rig.begin();
  RangeRig::put(robot, {0, 0, 1});
  for (const std::size_t ray : {0u, 1u, 2u, 3u}) {
    RangeRig::put(ball, Vec3d{0, 0, 1} + rotation_z(static_cast<double>(ray) * pi / 2) * Vec3d{2, 0, 0});
    rig.simulation.step();
    for (const std::size_t other : {0u, 1u, 2u, 3u}) {
      if (other == ray) {
        EXPECT_NEAR(reading.values[other], 1.9, 1e-12);
      } else {
        EXPECT_EQ(reading.values[other], infinity);
      }
    }
  }
  EXPECT_EQ(reading.info->outputs[0].name, "ranges");
  EXPECT_EQ(reading.info->outputs[0].labels, (std::vector<std::string>{"0", "1", "2", "3"}));
}

// The sensor sits inside of its own robot.
TEST(Laser, DoesNotSeeTheRobotThatCarriesItButAllOthers) {
  RangeRig rig;
  Entity& robot = rig.add_box("robot");
  Entity& other = rig.add_box("other");
  const Reading& reading = rig.attach(robot, test::sensor("laser", {{"rays", 1}, {"fov", 0}}));
  rig.begin();
  RangeRig::put(robot, {0, 0, 1});
  RangeRig::put(other, {3, 0, 1});
  rig.simulation.step();
  EXPECT_NEAR(reading.values[0], 2.85, 1e-12);
  RangeRig::put(other, {3, 1, 1});
  rig.simulation.step();
  EXPECT_EQ(reading.values[0], infinity);
}

SignalSpec everything_wrong() {
  SignalSpec signal;
  signal.noise = 0.01;
  signal.bias = 0.02;
  signal.low_pass = 30;
  signal.lowest = 0;
  signal.highest = 10;
  signal.resolution = 0.001;
  return signal;
}

// Law: errors, filter, saturation and steps of a converter leave infinities alone, and do not suffer from them.
TEST(Laser, OutsideOfItsRangeItShowsInfinities) {
  RangeRig rig;
  Entity& robot = rig.add_box("robot");
  Entity& ball = rig.add_ball("ball");
  SensorSpec spec = test::sensor("laser", {{"rays", 1}, {"fov", 0}, {"range_min", 0.5}, {"range_max", 4}});
  const Reading& plain = rig.attach(robot, spec);
  spec.name = "real";
  spec.signals["ranges"] = everything_wrong();
  const Reading& real = rig.attach(robot, spec);
  rig.begin();
  RangeRig::put(robot, {0, 0, 1});
  const auto at = [&](double x) {
    RangeRig::put(ball, {x, 0, 1});
    rig.run(0.1);
    return plain.values[0];
  };
  EXPECT_NEAR(at(2), 1.9, 1e-12);
  EXPECT_NEAR(real.values[0], 1.9, 0.15);
  EXPECT_EQ(at(4.2), infinity);
  EXPECT_EQ(real.values[0], infinity);
  EXPECT_NEAR(at(3), 2.9, 1e-12);
  EXPECT_NEAR(real.values[0], 2.9, 0.15);
  EXPECT_NEAR(real.values[0], 0.001 * std::round(real.values[0] * 1000), 1e-12);
  EXPECT_EQ(at(0.55), -infinity);
  EXPECT_EQ(real.values[0], -infinity);
  EXPECT_NEAR(at(1), 0.9, 1e-12);
  EXPECT_NEAR(real.values[0], 0.9, 0.15);
}

/// Three boxes that tumble past each other with lasers, detectors and sonars: what they have seen in the end.
std::uint64_t readings_of_tumblers(const std::string& volume, int threads) {
  RangeRig rig(threads);
  std::vector<const Reading*> readings;
  for (const char* name : {"one", "two", "three"}) rig.add_box(name, volume);
  for (Entity* robot : rig.moving_entities) {
    for (const char* type : {"laser", "detector", "sonar"}) {
      SensorSpec spec = test::sensor(type);
      if (spec.type == "detector") spec.numbers = {{"misses", 0.2}, {"distance_noise", 0.01}};
      spec.signals[""].noise = 0.01;
      spec.rate = 40;
      readings.push_back(&rig.attach(*robot, spec));
    }
  }
  rig.begin();
  double x = 0;
  for (Entity* robot : rig.moving_entities) {
    RangeRig::put(*robot, {x, 0.1 * x, 1});
    RangeRig::launch(*robot, {-0.5 * x, 0.3, 0}, {x, 1, 2 - x});
    x += 0.7;
  }
  rig.run(1);
  Hasher hasher;
  for (const Reading* reading : readings) append_hash(hasher, *reading);
  return hasher.value();
}

TEST(Laser, ThreadsAndVolumesChangeNoReading) {
  const std::uint64_t expected = readings_of_tumblers("sphere", 1);
  for (const int threads : {2, 3}) EXPECT_EQ(readings_of_tumblers("sphere", threads), expected);
  for (const char* volume : {"aabb", "obb", "capsule"}) EXPECT_EQ(readings_of_tumblers(volume, 1), expected) << volume;
}

TEST(Laser, ImpossibleNumbersAreNamed) {
  using fixtures::says;
  const auto message = [](const char* key, double number) {
    return test::error(test::sensor("laser", {{key, number}}));
  };
  EXPECT_TRUE(says(message("rays", 0), {"laser: ", "'rays' is 0", "a whole number in the range 1 to 100000"}));
  EXPECT_TRUE(says(message("rays", 100001), {"'rays' is 100001"}));
  EXPECT_TRUE(says(message("rays", 10.5), {"'rays' is 10.5", "whole number"}));
  EXPECT_TRUE(says(message("fov", -0.1), {"'fov' is -0.1"}));
  EXPECT_TRUE(says(message("fov", 7), {"'fov' is 7"}));
  EXPECT_TRUE(says(message("first_angle", std::nan("")), {"'first_angle' is nan"}));
  EXPECT_TRUE(says(message("range_min", -1), {"'range_min' is -1"}));
  EXPECT_TRUE(says(message("range_min", 30), {"range_min is 30", "range_max 30"}));
  EXPECT_EQ(message("rays", 100000), "no error");
  EXPECT_EQ(message("fov", 2 * 3.1416), "no error");
}

}  // namespace
}  // namespace murosimf::sensors
