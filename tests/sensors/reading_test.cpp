// Readings stand in columns of their robot: outputs by name, several sensors, their hash, and what is refused.
#include "murosimf/sensors/reading.h"

#include <gtest/gtest.h>

#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"
#include "tests/fixtures.h"

namespace murosimf::sensors {
namespace {

using fixtures::error_of;
using fixtures::says;

SensorInfo imu() {
  return {.name = "imu",
          .type = "imu",
          .outputs = {{"gyroscope", "rad/s", {"x", "y", "z"}}, {"heat", "K", {}}, {"pair", "m", {"a", "b"}}}};
}

/// A robot whose imu has the values 1 to 6, and a battery.
struct Robot {
  Robot() {
    imu_reading = &write_reading(setup, imu());
    battery = &write_reading(setup, {.name = "battery", .outputs = {{"voltage", "V", {}}}});
    (void)setup.write(properties::position);
    for (std::size_t i = 0; i < imu_reading->values.size(); ++i) imu_reading->values[i] = 1 + static_cast<double>(i);
  }
  World world;
  AccessSet access;
  Entity& entity = world.add("robot", std::make_shared<const Model>("dot", Chain{}.base()));
  Setup setup{world, entity, access};
  Reading *imu_reading = nullptr, *battery = nullptr;
};

std::vector<double> numbers(std::span<const double> span) { return {span.begin(), span.end()}; }

TEST(Reading, OutputsFollowEachOther) {
  const Robot robot;
  EXPECT_EQ(robot.imu_reading->info->numbers(), 6U);
  EXPECT_EQ(robot.battery->info->numbers(), 1U);
  EXPECT_EQ(numbers(robot.imu_reading->output("gyroscope")), (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(numbers(robot.imu_reading->output("heat")), (std::vector<double>{4}));
  EXPECT_EQ(numbers(robot.imu_reading->output("pair")), (std::vector<double>{5, 6}));
  EXPECT_EQ(robot.battery->values, (std::vector<double>{0})) << "nothing has come yet";
  EXPECT_TRUE(says(error_of([&] { (void)robot.imu_reading->output("gyroskope"); }),
                   {"sensor 'imu': unknown output 'gyroskope'; did you mean 'gyroscope'?"}));
}

TEST(Reading, IsFoundAmongOtherColumns) {
  Robot robot;
  EXPECT_EQ(find_reading(robot.entity, "imu"), robot.imu_reading);
  EXPECT_EQ(find_reading(robot.entity, "battery"), robot.battery);
  EXPECT_EQ(find_reading(robot.entity, "position"), nullptr);
  EXPECT_EQ(readings_of(robot.entity), (std::vector<const Reading*>{robot.battery, robot.imu_reading}));
}

// Taking a reading is the declaration that it is read.
TEST(Reading, IsReadByItsPath) {
  Robot robot;
  AccessSet others;
  murosimf::Setup reader(robot.world, robot.entity, others);
  EXPECT_EQ(numbers(read_output(reader, "imu.heat")), (std::vector<double>{4}));
  ASSERT_EQ(others.all().size(), 1U);
  EXPECT_EQ(others.all()[0].mode, AccessMode::read);
  EXPECT_EQ(others.all()[0].column->info().name, "sensor.imu");
  robot.battery->values[0] = 12;
  EXPECT_EQ(numbers(read_output(reader, "battery")), (std::vector<double>{12}));
  EXPECT_EQ(&read_reading(reader, "imu"), robot.imu_reading);
}

TEST(Reading, WhatThereIsNoneOfIsNamed) {
  Robot robot;
  EXPECT_TRUE(says(error_of([&] { (void)read_output(robot.setup, "imu"); }),
                   {"sensor 'imu' has several outputs", "'imu.gyroscope'"}));
  EXPECT_TRUE(says(error_of([&] { (void)read_output(robot.setup, "imo.heat"); }),
                   {"'robot': unknown sensor 'imo'; did you mean 'imu'?"}));
  EXPECT_TRUE(
      says(error_of([&] { (void)write_reading(robot.setup, imu()); }), {"'robot' has two sensors called 'imu'"}));
  Entity& other = robot.world.add("other", robot.entity.model_ptr());
  AccessSet access;
  murosimf::Setup setup(robot.world, other, access);
  EXPECT_EQ(error_of([&] { (void)read_reading(setup, "imu"); }), "'other' has no sensor 'imu', nor any other");
}

TEST(Reading, HashIsOfInstantCountAndNumbers) {
  const Robot robot;
  const std::uint64_t hash = hash_of(*robot.imu_reading);
  Reading other = *robot.imu_reading;
  EXPECT_EQ(hash_of(other), hash);
  other.values[5] = 7;
  EXPECT_NE(hash_of(other), hash);
  other = *robot.imu_reading;
  other.time = Duration{1};
  EXPECT_NE(hash_of(other), hash);
  other = *robot.imu_reading;
  other.samples = 1;
  EXPECT_NE(hash_of(other), hash);
}

}  // namespace
}  // namespace murosimf::sensors
