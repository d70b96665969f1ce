// Several changes at once are all made, or none: whatever came before the one that is wrong is undone.
#include <gtest/gtest.h>

#include "murosimf/scene/scene.h"
#include "tests/fixtures.h"
#include "tests/written_scene.h"

namespace murosimf::scene {
namespace {

using namespace std::chrono_literals;
using fixtures::error_of;

const char* const two_and_a_ball = R"(
[field]
size = "kid_size_2008"
[ball]
[[robots]]
name = "one"
model = "kid21"
level = "full_dynamics"
[[robots]]
name = "two"
model = "kid21"
level = "kinematic_walking"
position = [1, 0]
)";

/// Good ones of every kind.
const std::vector<std::string> good{"one.level = simplified_dynamics",
                                    "one.contact = kelvin_voigt",
                                    "one.servo_law = ideal_pd",
                                    "one.place = [0.5, 0.5, 0, 1]",
                                    "one.torso.push = [20, 0, 0, 0.1]",
                                    "two.present = false",
                                    "ball.ball.linear_velocity = [1, 0, 0]",
                                    "ball.radius = 0.1",
                                    "ball.color = [1, 0, 0]",
                                    "light.brightness = 0.5",
                                    "one.command = [0.1, 0, 0]",
                                    "one.j_head.joint_target = 0.2"};

struct Game {
  Game() : scene(fixtures::write_scene(two_and_a_ball), {.pushable = true}) { scene.simulation().run(300ms); }
  Scene scene;
};

TEST(SceneBatch, EveryKindOfChangeIsMadeAndIsACommand) {
  for (const std::string& text : good) {
    Game game;
    const auto before = game.scene.save();
    game.scene.change({text});
    EXPECT_FALSE(game.scene.save() == before) << text;
    EXPECT_EQ(game.scene.simulation().commands().size(), 1U) << text;
  }
}

TEST(SceneBatch, AWrongOneUndoesThoseBeforeIt) {
  const std::vector<std::string> wrong{
      "nonsense",                          // says nothing
      "three.level = full_dynamics",       // no such entity
      "one.level = ful_dynamics",          // no level
      "one.no_such_property = 1",          // nothing
      "one.torso.mass = -2",               // no mass
      "two.torso.push = [20, 0, 0, 0.1]",  // cannot be: it ignores forces, or is not there
      "one.present = true",                // it is
      "one.torso.position = [nan, 0, 0]",  // no number
      "ball.radius = -1"};
  Game game;
  Game untouched;
  const auto before = game.scene.save();
  const auto diagnostics = game.scene.parts().diagnostics.warnings();
  for (const std::string& bad : wrong) {
    std::vector<std::string> all = good;
    all.push_back(bad);
    EXPECT_NE(error_of([&] { game.scene.change(all); }), "no error") << bad;
    EXPECT_TRUE(game.scene.save() == before) << bad;
    EXPECT_EQ(game.scene.simulation().commands().size(), 0U) << bad;
    EXPECT_EQ(game.scene.parts().diagnostics.warnings(), diagnostics) << bad;
    for (const std::string& one : good) {
      EXPECT_NE(error_of([&] { game.scene.change({one, bad}); }), "no error") << one << ", " << bad;
      EXPECT_TRUE(game.scene.save() == before) << one << ", " << bad;
    }
  }
  game.scene.simulation().run(500ms);
  untouched.scene.simulation().run(500ms);
  EXPECT_EQ(game.scene.simulation().state_hash(), untouched.scene.simulation().state_hash());
}

// One change for several: one of them refuses.
TEST(SceneBatch, AChangeOfManyIsMadeOfAllOrNone) {
  Game game;
  const auto before = game.scene.save();
  EXPECT_NE(error_of([&] { game.scene.change({"*.torso.push = [20, 0, 0, 0.1]"}); }), "no error");
  EXPECT_TRUE(game.scene.save() == before);
}

TEST(SceneBatch, LaterOnesBuildOnEarlierOnes) {
  Game game;
  game.scene.change({"two.present = false", "two.present = true", "two.level = full_dynamics",
                     "two.torso.push = [5, 0, 0, 0.1]", "two.place = [2, 1, 0, 0]"});
  EXPECT_EQ(game.scene.simulation().commands().size(), 5U);
  EXPECT_EQ(game.scene.simulation().world().entity("two").level, "full_dynamics");
}

}  // namespace
}  // namespace murosimf::scene
