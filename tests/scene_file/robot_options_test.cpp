// [robots.options]: what arrives at the robot, and one line with its place for every error.
#include "murosimf/scene_file/robot_options.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include "murosimf/catalog/algorithm_catalog.h"
#include "tests/fixtures.h"
#include "tests/written_scene.h"

namespace murosimf::scene_file {
namespace {

using fixtures::error_of;
using fixtures::says;

const std::string game = R"([ball]
[defaults]
model = "kid21"
[defaults.options]
speed = 0.15
[[robots]]
name = "chaser"
controller = "ball_chaser"
[robots.options]
detour = 1
[[robots]]
name = "walker"
controller = "none"
[[robots]]
name = "crosser"
controller = "obstacle_course"
options = { speed = 0.1, camera = "eye" }
)";

/// Of every robot, as "number detour = 1; number speed = 0.15".
std::vector<std::string> options_of(const std::string& text, const std::vector<std::string>& set = {}) {
  std::vector<std::string> all;
  for (const RobotSpec& robot : read_scene(fixtures::write_scene(text), set).robots) {
    std::string& told = all.emplace_back();
    for (const auto& [name, value] : robot.options) {
      told += fmt::format("{}{} {} = {}", told.empty() ? "" : "; ", type_name(value), name, value_text(value));
    }
  }
  return all;
}

std::string refusal_of(const std::string& text, const std::vector<std::string>& set = {}) {
  return error_of([&] { (void)options_of(text, set); });
}

std::string with(const std::string& line, const std::string& instead) {
  std::string text = game;
  return text.replace(text.find(line), line.size(), instead);
}

// Whole numbers are numbers. A default is for those whose controller has it; the robot's own wins.
TEST(RobotOptions, AreThoseOfTheRobotThenTheDefaults) {
  const auto robots = options_of(game);
  EXPECT_EQ(robots.at(0), "number detour = 1; number speed = 0.15");
  EXPECT_EQ(robots.at(1), "");
  EXPECT_EQ(robots.at(2), "text camera = eye; number speed = 0.1");
}

TEST(RobotOptions, AreSetFromTheCommandLine) {
  const auto robots =
      options_of(game, {"chaser.options.detour=0.3", "defaults.options.speed=0.2", "c*.options.speed=0.11"});
  EXPECT_EQ(robots.at(0), "number detour = 0.3; number speed = 0.11");
  EXPECT_EQ(robots.at(2), "text camera = eye; number speed = 0.11");
}

TEST(RobotOptions, OfOtherControllersAreRefusedWithTheirPlace) {
  EXPECT_TRUE(says(refusal_of(with("detour = 1", "detuor = 1")),
                   {".toml:10:1: unknown option of controller 'ball_chaser', 'detuor'; did you mean 'detour'?"}));
  EXPECT_TRUE(says(refusal_of(with("speed = 0.15", "sped = 0.15")),
                   {".toml:5:1: unknown option of the controllers of this scene, 'sped'; did you mean 'speed'?"}));
  EXPECT_TRUE(says(refusal_of(game, {"walker.options.speed=1"}),
                   {"--set 'walker.options.speed=1': controller 'none' has no options, so 'speed' is none"}));
}

TEST(RobotOptions, OfAnotherTypeOrOutOfRangeAreRefused) {
  EXPECT_TRUE(
      says(refusal_of(with("detour = 1", "detour = \"far\"")), {".toml:10:10: 'detour' must be a finite number"}));
  EXPECT_TRUE(says(refusal_of(with("detour = 1", "detour = -1")),
                   {".toml:10:10: 'detour' is -1; it must be in the range 0 to 100 m"}));
  EXPECT_TRUE(says(refusal_of(with("speed = 0.15", "speed = 11")), {".toml:5:9: 'speed' is 11"}));
  EXPECT_TRUE(says(refusal_of(with("\"eye\"", "3")), {"'camera' must be a text in quotes"}));
  EXPECT_TRUE(says(refusal_of(with("options = { speed = 0.1, camera = \"eye\" }", "options = 3")),
                   {"'options' must be a table"}));
  EXPECT_TRUE(says(refusal_of(game, {"chaser.options.detour.x=1"}), {"write options.KEY"}));
  EXPECT_TRUE(says(refusal_of(game, {"chaser.options=1"}), {"'options' must be a table"}));
}

// What a program adds before it reads a scene is known to the scene, its options too.
TEST(RobotOptions, OfAnAddedControllerAreKnown) {
  if (!catalog::controllers().look_for("spin")) {
    catalog::registries().controllers.add({"spin",
                                           "turns on the spot",
                                           "",
                                           [](auto&, auto&, const auto&) {},
                                           {{"rate", 1.0, "rad/s", "of turning", 0, 2}}});
  }
  const auto robots = options_of(game, {"walker.controller=spin", "walker.options.rate=0.5"});
  EXPECT_EQ(robots.at(1), "number rate = 0.5");
  EXPECT_TRUE(
      says(refusal_of(game, {"walker.controller=spin", "walker.options.rate=3"}), {"'rate' is 3", "0 to 2 rad/s"}));
}

}  // namespace
}  // namespace murosimf::scene_file
