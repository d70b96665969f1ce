// Pushes: --push and [[pushes]].
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "murosimf/model/properties.h"
#include "murosimf/scene/scene.h"
#include "murosimf/scene/scene_report.h"
#include "tests/written_scene.h"

namespace murosimf::scene_file {
namespace {

/// A box that floats, and a kinematic robot far away.
std::string pushed_scene(const std::string& more = {}) {
  return fixtures::write_scene(R"(gravity = [0, 0, 0]
[[bodies]]
name = "box"
shape = "box"
size = [0.2, 0.2, 0.2]
mass = 2
position = [0, 0, 1]
angular_velocity = [0, 0, 3]
[[bodies]]
name = "wall"
shape = "box"
size = [0.2, 0.2, 0.2]
position = [2, 0]
static = true
[[robots]]
name = "r"
model = "kid21"
position = [-2, 0]
)" + more);
}

std::string push_mistake(const std::string& push, const std::vector<std::string>& events = {}) {
  try {
    const scene::Scene scene(pushed_scene(), {.events = events, .pushes = {push}});
  } catch (const SetupError& error) {
    return error.what();
  }
  return {};
}

bool says_all(const std::string& text, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) {
    if (text.find(part) == std::string::npos) return false;
  }
  return true;
}

/// Velocity of the box after 50 ms.
Vec3d velocity_after(const scene::SceneOptions& options, const std::string& more = {}) {
  scene::Scene scene(pushed_scene(more), options);
  scene.simulation().run(std::chrono::milliseconds(50));
  return scene.simulation().world().entity("box").base().get(properties::linear_velocity);
}

TEST(Pushes, GiveTheirImpulseWhateverTheStep) {
  EXPECT_NEAR(velocity_after({.pushes = {"box=[60,0,0]@0.01..0.03"}}).x, 60 * 0.02 / 2, 1e-9);
  EXPECT_NEAR(velocity_after({.pushes = {"box=[60,0,0]@0.0104..0.0107"}}).x, 60 * 0.0003 / 2, 1e-9) << "within a step";
  EXPECT_NEAR(velocity_after({.pushes = {"box=[60,0,0]@0.01..0.02", "box.box=[0,30,0]@0.015..0.025"}}).y, 0.15, 1e-9);
  EXPECT_NEAR(velocity_after({}, "[[pushes]]\non = \"box\"\nforce = [0, 0, 60]\nfrom = 0.01\nto = 0.03\n").z, 0.6,
              1e-9);
}

TEST(Pushes, ActAtTheCenterOfMassAndTurnNothing) {
  scene::Scene scene(pushed_scene(),
                     {.overrides = {"box.box.center_of_mass=[0.05,0,0]"}, .pushes = {"box=[60,0,0]@0.01..0.03"}});
  scene.simulation().run(std::chrono::milliseconds(50));
  EXPECT_NEAR(scene.simulation().world().entity("box").base().get(properties::angular_velocity).z, 3, 1e-6);
}

TEST(Pushes, HaveMomentsByNameOrAsTheLastThree) {
  const auto turning = [](const std::string& push) {
    scene::Scene scene(pushed_scene(), {.pushes = {push}});
    scene.simulation().run(std::chrono::milliseconds(50));
    return scene.simulation().world().entity("box").base().get(properties::angular_velocity).z;
  };
  const double inertia = 2 * (0.04 + 0.04) / 12;
  EXPECT_NEAR(turning("box=[0,0,0,0,0,1]@0.01..0.03"), 3 + 0.02 / inertia, 1e-9);
  EXPECT_NEAR(turning("box={moment=[0,0,1]}@0.01..0.03"), 3 + 0.02 / inertia, 1e-9);
}

TEST(Pushes, ComeOnTopOfWhatUsersSet) {
  const Vec3d v =
      velocity_after({.overrides = {"box.box.applied_force={force=[0,2,0]}"}, .pushes = {"box=[60,0,0]@0.01..0.03"}});
  EXPECT_NEAR(v.x, 0.6, 1e-9);
  EXPECT_NEAR(v.y, 0.05, 1e-9);
}

TEST(Pushes, AreEventsOfTheReport) {
  scene::Scene scene(pushed_scene(), {.pushes = {"box=[60,0,0]@0.01..0.03"}});
  scene.simulation().run(std::chrono::milliseconds(50));
  const auto events = make_report(scene).events;
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].text, "push on box.box: force (60, 0, 0) N, until 0.03 s");
  EXPECT_EQ(events[0].time, std::chrono::milliseconds(10));
}

TEST(Pushes, AreRefusedBeforeTheRun) {
  EXPECT_TRUE(says_all(push_mistake("bx=[1,0,0]@0..1"), {"--push 'bx=[1,0,0]@0..1'", "unknown entity 'bx'", "box"}));
  EXPECT_TRUE(says_all(push_mistake("box.lid=[1,0,0]@0..1"), {"unknown object 'lid'"}));
  EXPECT_TRUE(says_all(push_mistake("wall=[1,0,0]@0..1"), {"stands there for good"}));
  EXPECT_TRUE(says_all(push_mistake("box=[1,0,0]"), {"write OBJECT=FORCE@BEGIN..END"}));
  EXPECT_TRUE(says_all(push_mistake("box=[1,0]@0..1"), {"three numbers"}));
  EXPECT_TRUE(says_all(push_mistake("box={frce=[1,0,0]}@0..1"), {"did you mean 'force'?"}));
  EXPECT_TRUE(says_all(push_mistake("box=[1,0,0]@2..1"), {"before it begins"}));
  EXPECT_TRUE(says_all(push_mistake("box=[1,0,0]@x..1"), {"'x' is no time in seconds"}));
  EXPECT_TRUE(says_all(push_mistake("box=[1,0,nan]@0..1"), {"finite"}));
  EXPECT_TRUE(says_all(push_mistake("r.torso=[1,0,0]@1..2"), {"'r' is at kinematic_walking", "simplified_dynamics"}));
  EXPECT_EQ(push_mistake("r.torso=[1,0,0]@1..2", {"0.5:r.level=full_dynamics"}), "") << "it is dynamic by then";
}

TEST(Pushes, ThatTheRunDoesNotReachAreNamed) {
  scene::Scene scene(pushed_scene(), {.pushes = {"box=[60,0,0]@0.001..0.002", "box=[60,0,0]@3..4"}});
  scene.simulation().run(std::chrono::milliseconds(20));
  const auto warnings = make_report(scene).warnings;
  const auto late = std::ranges::find_if(warnings, [](const std::string& w) {
    return says_all(w, {"1 of 2 events and pushes", "the first at 3.000 s"});
  });
  EXPECT_NE(late, warnings.end());
}

}  // namespace
}  // namespace murosimf::scene_file
