// Bodies that go into each other or through each other while a scene runs are warnings, whatever they are.
#include "murosimf/scene/interpenetration_warnings.h"

#include <gtest/gtest.h>

#include "murosimf/model/properties.h"
#include "murosimf/scene/scene.h"
#include "murosimf/scene/scene_report.h"
#include "tests/fixtures.h"
#include "tests/scene/scene_hashes.h"
#include "tests/written_scene.h"

namespace murosimf::scene {
namespace {

using namespace std::chrono_literals;
using fixtures::says;

std::vector<std::string> warnings_of(Scene& scene) { return interpenetration_warnings(scene.simulation().world()); }

std::string press(double heavy) {
  return "[[bodies]]\nname = 'light'\nshape = 'box'\nsize = [0.2, 0.2, 0.02]\nmass = 0.5\nposition = [0.3, 0]\n"
         "[[bodies]]\nname = 'heavy'\nshape = 'box'\nsize = [0.1, 0.1, 0.1]\nposition = [0.3, 0, 0.02]\nmass = " +
         std::to_string(heavy) + "\n";
}

// 100:1 holds in steps of any length; 1000:1 presses the plate into the ground.
TEST(InterpenetrationWarnings, OfWhatIsPressedIntoTheGround) {
  for (const std::string rate : {"rate=1000", "rate=200"}) {
    Scene good(fixtures::write_scene(press(50)), {.overrides = {rate}});
    good.simulation().run(2s);
    EXPECT_TRUE(warnings_of(good).empty());
    Scene scene(fixtures::write_scene(press(500)), {.overrides = {rate}});
    scene.simulation().run(2s);
    const auto warnings = warnings_of(scene);
    ASSERT_FALSE(warnings.empty()) << rate;
    EXPECT_TRUE(says(warnings[0], {"light and field", "mm in each other", "20.0 mm thick"})) << warnings[0];
    EXPECT_TRUE(says(make_report(scene).warnings.back(), {"in each other"}));
  }
}

/// Two bullets, at a plate that gives way and at a wall.
std::string bullets(double speed) {
  const std::string v = std::to_string(speed);
  return R"(
gravity = [0, 0, 0]
[field]
goals = false
[[bodies]]
name = "plate"
shape = "box"
size = [0.02, 0.4, 0.4]
mass = 1
position = [0.5, 0, 0.8]
[[bodies]]
name = "wall"
static = true
shape = "box"
size = [0.02, 0.4, 0.4]
position = [-0.5, 0, 0.8]
[[bodies]]
name = "one"
shape = "sphere"
radius = 0.02
mass = 1
position = [0.1, 0, 0.98]
velocity = [)" +
         v + ", 0, 0]\n" +
         "[[bodies]]\nname = 'two'\nshape = 'sphere'\nradius = 0.02\nmass = 1\nposition = [-0.1, 0, 0.98]\nvelocity = "
         "[-" +
         v + ", 0, 0]\n";
}

// Whatever the phase at which it comes, up to 1.3 m in a step: no body is on the other side (collision/continuous_collision.h).
TEST(InterpenetrationWarnings, NobodyComesThrough) {
  for (const double speed : {2.0, 10.0, 21.0, 43.0, 61.0, 77.0, 101.0, 130.0}) {
    for (const std::string rate : {"1000", "500", "200", "100"}) {
      Scene scene(fixtures::write_scene(bullets(speed)), {.overrides = {"rate=" + rate}});
      scene.simulation().run(500ms);
      const auto x = [&](const char* name) {
        return scene.simulation().world().entity(name).base().get(properties::position).x;
      };
      EXPECT_LT(x("one"), x("plate")) << speed << " m/s at " << rate;
      EXPECT_GT(x("two"), -0.5) << speed << " m/s at " << rate;
      for (const std::string& warning : warnings_of(scene)) EXPECT_FALSE(says(warning, {"passed through"})) << warning;
    }
  }
}

TEST(InterpenetrationWarnings, AreAtMostSixLines) {
  Scene scene("heap");
  scene.simulation().run(1s);
  const auto warnings = warnings_of(scene);
  ASSERT_EQ(warnings.size(), 6u);
  EXPECT_TRUE(says(warnings[5], {"more pairs"}));
}

// They are part of the state, and a reset forgets them.
TEST(InterpenetrationWarnings, GoWithTheState) {
  const std::string file = fixtures::write_scene(press(500));
  Scene scene(file), other(file);
  scene.simulation().run(2s);
  const auto expected = warnings_of(scene);
  ASSERT_FALSE(expected.empty());
  other.load(scene.save());
  EXPECT_EQ(warnings_of(other), expected);
  other.reset();
  EXPECT_TRUE(warnings_of(other).empty());
}

}  // namespace
}  // namespace murosimf::scene
