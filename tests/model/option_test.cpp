// Options of algorithms: what is told about them, what is refused, where values go.
#include "murosimf/model/option.h"

#include <gtest/gtest.h>

#include "tests/fixtures.h"

namespace murosimf {
namespace {

using fixtures::error_of;

struct Socket {
  double current = 16;
};

struct Lamp {
  int bulbs = 1;
  std::optional<double> height{};
  double life = any_number;
  Socket socket;
  double power = 7.5;
  bool on = true;
  std::string color = "white";
  Vec3d toward{0, 0, -1};
};

const OptionTable<Lamp> lamp_options{
    {"power", &Lamp::power, "W", "what it takes", 2, 90},
    {"on", &Lamp::on, "", "whether it shines"},
    {"color", &Lamp::color, "", "of its light", std::vector<std::string>{"white", "red", "amber"}},
    {"toward", &Lamp::toward, "m", "where it looks", 0, 10},
    {"bulbs", &Lamp::bulbs, "1", "how many", 1, 5},
    {"height", &Lamp::height, "m", "above the floor; without it where it hangs", above(0)},
    {"life", &Lamp::life, "h", "until it breaks"},
    {"current", [](auto& lamp) -> decltype(auto) { return (lamp.socket.current); }, "A", "of the socket", above(0), 20},
};

Lamp lamp_with(const OptionValues& given) {
  Lamp lamp;
  lamp_options.apply(given, lamp);
  return lamp;
}

std::string refusal_of(const OptionValues& given) {
  return error_of([&] { (void)lamp_with(given); });
}

TEST(Option, DefaultsAreThoseOfTheStruct) {
  const auto infos = lamp_options.infos();
  ASSERT_EQ(infos.size(), 8u);
  std::vector<std::string> told;
  for (const OptionInfo& option : infos) {
    told.push_back(std::string(type_name(option)) + " " + default_text(option) + " " + range_text(option));
  }
  EXPECT_EQ(told, (std::vector<std::string>{"number 7.5 2 to 90", "boolean true ", "text white white, red, amber",
                                            "vector [0, 0, -1] 0 to 10", "integer 1 1 to 5", "number - above 0",
                                            "number inf ", "number 16 above 0 to 20"}));
  EXPECT_EQ(infos[0].unit, "W");
  EXPECT_EQ(infos[0].meaning, "what it takes");
  EXPECT_EQ(option_names(infos),
            (std::vector<std::string_view>{"power", "on", "color", "toward", "bulbs", "height", "life", "current"}));
}

TEST(Option, ValuesGoWhereTheyBelong) {
  const Lamp lamp = lamp_with({{"power", 60.0}, {"on", false}, {"color", "red"}, {"toward", Vec3d{1, 2, 3}}});
  EXPECT_EQ(lamp.power, 60);
  EXPECT_FALSE(lamp.on);
  EXPECT_EQ(lamp.color, "red");
  EXPECT_EQ(norm(lamp.toward - Vec3d{1, 2, 3}), 0);
  EXPECT_EQ(lamp_with({{"on", false}}).power, 7.5) << "what is not given stays";
  const Lamp other = lamp_with({{"bulbs", 4.0}, {"height", 2.5}, {"current", 10.0}, {"life", any_number}});
  EXPECT_EQ(other.bulbs, 4);
  EXPECT_EQ(other.height, 2.5);
  EXPECT_EQ(other.socket.current, 10) << "in a struct of the struct";
  EXPECT_EQ(value_text(lamp_options.values(other)[4]), "4");
  EXPECT_FALSE(lamp.height.has_value());
}

TEST(Option, EndsOfARangeAreInIt) {
  EXPECT_EQ(refusal_of({{"power", 2.0}}), "no error");
  EXPECT_EQ(refusal_of({{"power", 90.0}}), "no error");
  EXPECT_EQ(refusal_of({{"power", 1.99}}), "'power' is 1.99; it must be in the range 2 to 90 W");
  EXPECT_EQ(refusal_of({{"power", 90.1}}), "'power' is 90.1; it must be in the range 2 to 90 W");
  EXPECT_EQ(refusal_of({{"toward", Vec3d{8, 8, 0}}}), "'toward' is [8, 8, 0]; it must be in the range 0 to 10 m");
  EXPECT_NE(refusal_of({{"power", std::numeric_limits<double>::quiet_NaN()}}), "no error");
}

TEST(Option, OpenEndsAreNotInARange) {
  EXPECT_EQ(refusal_of({{"current", 20.0}}), "no error");
  EXPECT_EQ(refusal_of({{"current", 0.0}}), "'current' is 0; it must be in the range above 0 to 20 A");
  EXPECT_EQ(refusal_of({{"height", 0.0}}), "'height' is 0; it must be in the range above 0 m");
}

TEST(Option, WholeNumbersHaveNoFraction) {
  EXPECT_EQ(refusal_of({{"bulbs", 2.5}}), "'bulbs' is 2.5; it must be a whole number in the range 1 to 5");
  EXPECT_EQ(refusal_of({{"bulbs", 6.0}}), "'bulbs' is 6; it must be a whole number in the range 1 to 5");
}

TEST(Option, TextsAreOneOfTheChoices) {
  EXPECT_EQ(refusal_of({{"color", "amber"}}), "no error");
  EXPECT_EQ(refusal_of({{"color", "ambre"}}), "unknown color 'ambre'; did you mean 'amber'?");
}

// Where the default is infinite, infinite is a value; elsewhere it is an error.
TEST(Option, InfiniteOnlyWhereTheDefaultIs) {
  EXPECT_EQ(refusal_of({{"life", any_number}}), "no error");
  EXPECT_NE(refusal_of({{"height", any_number}}), "no error");
}

TEST(Option, RefusesOtherTypesAndNames) {
  EXPECT_EQ(refusal_of({{"power", true}}), "'power' is a boolean; it must be a number");
  EXPECT_EQ(refusal_of({{"color", 1.0}}), "'color' is a number; it must be a text");
  EXPECT_EQ(refusal_of({{"on", 1.0}}), "'on' is a number; it must be true or false");
  EXPECT_EQ(refusal_of({{"powr", 3.0}}), "unknown option of this algorithm, 'powr'; did you mean 'power'?");
  EXPECT_EQ(error_of([] {
              check_options("controller 'none'", {}, {{"speed", 1.0}});
            }),
            "controller 'none' has no options, so 'speed' cannot be set");
}

}  // namespace
}  // namespace murosimf
