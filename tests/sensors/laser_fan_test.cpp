// The fan of a laser range finder: its rays, its sector, its range, and what is impossible.
#include "murosimf/sensors/laser_fan.h"

#include <gtest/gtest.h>

#include "murosimf/model/error.h"
#include "tests/fixtures.h"

namespace murosimf::sensors {
namespace {

using fixtures::error_of;
using fixtures::says;

TEST(LaserFan, OfAHokuyoIfNothingIsSaid) {
  EXPECT_EQ(laser_ranges({}).size(), 1081U);
  const LaserSector sector = laser_sector({});
  EXPECT_EQ(sector.rays, 1081);
  EXPECT_EQ(sector.fov, 1.5 * pi);
  EXPECT_EQ(sector.first, -0.75 * pi);
  EXPECT_EQ(laser_range({}).min, 0.06);
  EXPECT_EQ(laser_range({}).max, 30);
}

TEST(LaserFan, HasALabelForEachRay) {
  const Output output = laser_ranges({.numbers = {{"rays", 3}}});
  EXPECT_EQ(output.name, "ranges");
  EXPECT_EQ(output.unit, "m");
  EXPECT_EQ(output.labels, (std::vector<std::string>{"0", "1", "2"}));
  EXPECT_EQ(laser_ranges({.numbers = {{"rays", 1}}}).labels.size(), 1U);
}

TEST(LaserFan, SectorBeginsHalfOfItToTheRightOrWhereSaid) {
  EXPECT_EQ(laser_sector({.numbers = {{"fov", 1.2}}}).first, -0.6);
  const LaserSector sector = laser_sector({.numbers = {{"fov", 1.2}, {"first_angle", 0.3}, {"rays", 7}}});
  EXPECT_EQ(sector.first, 0.3);
  EXPECT_EQ(sector.fov, 1.2);
  EXPECT_EQ(sector.rays, 7);
}

TEST(LaserFan, ImpossibleNumbersAreNamed) {
  const auto error = [](const std::string& key, double number) {
    return error_of([&] { (void)laser_sector({.numbers = {{key, number}}}); });
  };
  EXPECT_TRUE(says(error("rays", 0), {"'rays' is 0"}));
  EXPECT_TRUE(says(error("rays", 100001), {"'rays' is 100001"}));
  EXPECT_EQ(error("rays", 100000), "no error");
  EXPECT_EQ(error("first_angle", -2 * pi), "no error");
  EXPECT_EQ(error("first_angle", 2 * pi), "no error");
  EXPECT_TRUE(says(error("first_angle", -6.3), {"'first_angle' is -6.3"}));
  EXPECT_TRUE(says(error("first_angle", 6.3), {"'first_angle' is 6.3"}));
  EXPECT_TRUE(says(error("fov", 6.3), {"'fov' is 6.3"}));
}

}  // namespace
}  // namespace murosimf::sensors
