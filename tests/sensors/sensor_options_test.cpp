// Options that only one type of sensor has, from what its spec gives; and that rounded angles count as all round.
#include "murosimf/sensors/sensor_options.h"

#include <gtest/gtest.h>

#include "murosimf/sensors/detector.h"
#include "murosimf/sensors/laser_fan.h"
#include "tests/fixtures.h"

namespace murosimf::sensors {
namespace {

using fixtures::error_of;

struct Lamp {
  int bulbs = 3;
  bool on = true;
  double power = 7.5;
  std::string color = "white";
};

const OptionTable<Lamp>& lamp() {
  static const OptionTable<Lamp> table{
      {"bulbs", &Lamp::bulbs, "1", "how many", 1, 5},
      {"on", &Lamp::on, "", "whether it shines"},
      {"power", &Lamp::power, "W", "what it takes", above(0)},
      {"color", &Lamp::color, "", "of its light", std::vector<std::string>{"white", "red"}},
  };
  return table;
}

TEST(SensorOptions, AreDefaultsAndWhatIsGiven) {
  const Lamp none = options_of({}, lamp());
  EXPECT_EQ(none.bulbs, 3);
  EXPECT_TRUE(none.on);
  const Lamp some =
      options_of({.numbers = {{"bulbs", 5}, {"on", 0}, {"other", 8}}, .texts = {{"color", "red"}}}, lamp());
  EXPECT_EQ(some.bulbs, 5);
  EXPECT_FALSE(some.on) << "flags are numbers in a spec";
  EXPECT_EQ(some.power, 7.5);
  EXPECT_EQ(some.color, "red");
}

TEST(SensorOptions, ImpossibleOnesAreNamed) {
  const auto error = [](const SensorSpec& spec) { return error_of([&] { (void)options_of(spec, lamp()); }); };
  EXPECT_EQ(error({.numbers = {{"bulbs", 6}}}), "'bulbs' is 6; it must be a whole number in the range 1 to 5");
  EXPECT_EQ(error({.numbers = {{"bulbs", 1.5}}}), "'bulbs' is 1.5; it must be a whole number in the range 1 to 5");
  EXPECT_EQ(error({.numbers = {{"power", 0}}}), "'power' is 0; it must be in the range above 0 W");
  EXPECT_EQ(error({.numbers = {{"color", 1}}}), "'color' is a number; it must be a text");
  EXPECT_EQ(error({.texts = {{"color", "blue"}}}), "unknown color 'blue'; known: white, red");
}

// Rule: 3.1416 to both sides is meant as all round.
TEST(SensorOptions, RoundedAnglesCountAsAllRound) {
  EXPECT_EQ(laser_sector({.numbers = {{"fov", 6.2832}}}).fov, 2 * pi);
  EXPECT_EQ(laser_sector({.numbers = {{"fov", 0.3}}}).fov, 0.3);
  EXPECT_NE(error_of([] { (void)laser_sector({.numbers = {{"fov", 6.2833}}}); }), "no error");
  const auto elevation = [](double angle) {
    return error_of([&] { (void)options_of({.numbers = {{"fov_elevation", angle}}}, detector_options()); });
  };
  EXPECT_EQ(elevation(3.1416), "no error");
  EXPECT_NE(elevation(3.1417), "no error");
}

// An infinite number is taken where the default is infinite.
TEST(SensorOptions, MayBeInfiniteWhereTheDefaultIs) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(options_of({.numbers = {{"range_max", infinity}}}, detector_options()).range.max, infinity);
  EXPECT_NE(error_of([&] { (void)laser_range({.numbers = {{"range_max", infinity}}}); }), "no error");
}

}  // namespace
}  // namespace murosimf::sensors
