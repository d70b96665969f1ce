// [robots.level_options], [robots.contact_options] and [body_contact_options]: what arrives, and one line for every error.
#include <gtest/gtest.h>

#include "murosimf/scene_file/unused_settings.h"
#include "tests/fixtures.h"
#include "tests/written_scene.h"

namespace murosimf::scene_file {
namespace {

using fixtures::error_of;
using fixtures::says;

const std::string two = R"([defaults]
model = "kid21"
[defaults.level_options]
filter_frequency = 90
[[robots]]
name = "one"
level = "full_dynamics"
contact = "paper"
[robots.level_options]
momentum_correction = false
[robots.contact_options]
friction = 3
[[robots]]
name = "two"
[body_contact_options]
sweeps = 20
)";

/// "friction = 3; rebound = 0.2"
std::string text_of(const OptionValues& values) {
  std::string text;
  for (const auto& [name, value] : values) text += (text.empty() ? "" : "; ") + name + " = " + value_text(value);
  return text;
}

SceneSpec spec_of(const std::vector<std::string>& set = {}, const std::string& text = two) {
  return read_scene(fixtures::write_scene(text), set);
}

std::string refusal_of(const std::vector<std::string>& set, const std::string& text = two) {
  return error_of([&] { (void)spec_of(set, text); });
}

TEST(LevelAndLawOptions, ArriveAtTheirRobots) {
  const SceneSpec spec = spec_of();
  EXPECT_EQ(text_of(spec.robots[0].level_options), "filter_frequency = 90; momentum_correction = false");
  EXPECT_EQ(text_of(spec.robots[0].contact_options), "friction = 3");
  EXPECT_EQ(text_of(spec.robots[1].level_options), "filter_frequency = 90");
  EXPECT_TRUE(spec.robots[1].contact_options.empty());
  EXPECT_EQ(text_of(spec.body_contact_options), "sweeps = 20");
}

TEST(LevelAndLawOptions, AreSetOnTheCommandLine) {
  const SceneSpec spec = spec_of({"one.contact_options.rebound=0.2", "defaults.level_options.control_period=0.02",
                                  "body_contact_options.sweeps=3"});
  EXPECT_EQ(text_of(spec.robots[0].contact_options), "friction = 3; rebound = 0.2");
  EXPECT_EQ(text_of(spec.robots[1].level_options), "control_period = 0.02; filter_frequency = 90");
  EXPECT_EQ(text_of(spec.body_contact_options), "sweeps = 3");
}

TEST(LevelAndLawOptions, MistakesAreOneLineThatSaysWhere) {
  EXPECT_TRUE(says(refusal_of({"one.contact_options.frction=1"}),
                   {"--set 'one.contact_options.frction=1'", "contact law 'paper'", "did you mean 'friction'?"}));
  EXPECT_TRUE(says(refusal_of({"one.contact_options.rebound=2"}), {"'rebound' is 2; it must be in the range 0 to 1"}));
  EXPECT_TRUE(
      says(refusal_of({"one.level_options.momentum_correction=1"}), {"'momentum_correction' must be true or false"}));
  EXPECT_TRUE(says(refusal_of({"defaults.level_options.filter=1"}), {"the levels of this scene", "'filter'"}));
  EXPECT_TRUE(says(refusal_of({"body_contact_options.sweeps=2.5"}), {"a whole number in the range 1 to 1000"}));
  EXPECT_TRUE(says(refusal_of({"body_contact=\"carry\""}),
                   {"law of contact between bodies 'carry' has no options, so 'sweeps' is none"}));
  std::string text = two;
  text.replace(text.find("friction = 3"), 12, "friction = -3");
  EXPECT_TRUE(says(refusal_of({}, text), {".toml:12:", "'friction' is -3; it must be in the range 0 to 100 s/m"}));
}

// A robot that runs at several levels keeps what only another of them has; what none of them has is told.
TEST(LevelAndLawOptions, ThatActOnNothingAreTold) {
  const auto told = [](const std::vector<std::string>& set) {
    std::string all;
    for (const std::string& line : unused_keys(spec_of(set))) all += line + "\n";
    return all;
  };
  EXPECT_EQ(told({}), "");
  EXPECT_TRUE(says(told({"one.level=simplified_dynamics"}),
                   {"one: simplified_dynamics has no 'momentum_correction' in 'level_options'; it changes nothing"}));
  EXPECT_TRUE(says(told({"one.contact=kelvin_voigt"}), {"one: kelvin_voigt has no 'friction' in 'contact_options'"}));
  EXPECT_TRUE(says(told({"one.level=kinematic_walking"}), {"'contact_options'"}));
}

}  // namespace
}  // namespace murosimf::scene_file
