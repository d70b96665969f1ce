// Robots that are put somewhere else while a scene runs: at every level they stand there, and go on.
#include "murosimf/scene/robot_placement.h"

#include <gtest/gtest.h>

#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/model/properties.h"
#include "murosimf/scene/scene.h"
#include "tests/fixtures.h"
#include "tests/written_scene.h"

namespace murosimf::scene {
namespace {

using namespace std::chrono_literals;

const std::vector<std::string> levels{"kinematic_walking", "simplified_dynamics", "full_dynamics",
                                      "articulated_dynamics"};

SceneOptions walker_at(const std::string& level) {
  return {.overrides = {"walker.level=" + level, "walker.command=[0, 0, 0]"}, .cameras = false};
}

Vec3d where(const Scene& scene) {
  return scene.simulation().world().entity("walker").find(properties::position)->values[0];
}
double height(const Scene& scene) { return where(scene).z; }

/// [rad] Of the base's x, in the ground.
double heading(Scene& scene) {
  const Vec3d x = scene.simulation().world().entity("walker").base().get(properties::orientation) * Vec3d{1, 0, 0};
  return std::atan2(x.y, x.x);
}

TEST(RobotPlacement, StandsThereAtEveryLevel) {
  for (const std::string& level : levels) {
    Scene scene("walk", walker_at(level));
    scene.simulation().run(500ms);
    const double before = height(scene);
    place(scene.parts(), "walker", {{1.5, -0.7, 0}, 2.0});
    EXPECT_NEAR(where(scene).x, 1.5, 1e-12) << level;
    scene.simulation().run(1s);
    EXPECT_NEAR(where(scene).x, 1.5, 0.02) << level;
    EXPECT_NEAR(where(scene).y, -0.7, 0.02) << level;
    EXPECT_NEAR(height(scene), before, 0.003) << level;
    EXPECT_NEAR(heading(scene), 2.0, 0.05) << level;
    EXPECT_EQ(scene.simulation().world().entity("walker").base().get(properties::falls), 0) << level;
    EXPECT_FALSE(scene.simulation().world().entity("walker").frozen());
  }
}

TEST(RobotPlacement, PutsWhoHasFallenOnItsFeet) {
  for (const std::string& level : levels) {
    if (level == "kinematic_walking") continue;  // which cannot fall
    SceneOptions options = walker_at(level);
    options.overrides.push_back("walker.pitch_deg=80");
    options.overrides.push_back("walker.position=[0, 0, 0.2]");
    Scene scene("walk", options);
    scene.simulation().run(2s);
    const double lying = height(scene);
    place(scene.parts(), "walker", {{1, 0, 0}, 0});
    EXPECT_GT(height(scene), lying + 0.1) << level;
    scene.simulation().run(500ms);
    EXPECT_GT(height(scene), lying + 0.1) << level;
    EXPECT_NEAR(where(scene).x, 1, 0.05) << level;
  }
}

TEST(RobotPlacement, TakesNoSpeedAlong) {
  for (const std::string& level : levels) {
    Scene scene("walk", walker_at(level));
    scene.simulation().run(100ms);
    scene.simulation().world().entity("walker").base().set(properties::linear_velocity, {2, 1, 0.5});
    scene.simulation().run(20ms);
    place(scene.parts(), "walker", {{1, 0, 0}, 0});
    scene.simulation().run(1s);
    EXPECT_NEAR(where(scene).x, 1, 0.02) << level;
    EXPECT_NEAR(where(scene).y, 0, 0.02) << level;
  }
}

TEST(RobotPlacement, IsTheSameAgain) {
  const auto run = [] {
    Scene scene("walk", walker_at("full_dynamics"));
    scene.simulation().at(300ms, [&] { place(scene.parts(), "walker", {{-1, 0.5, 0}, -1}); });
    scene.simulation().run(1s);
    return scene.simulation().state_hash();
  };
  EXPECT_EQ(run(), run());
}

// As events and commands: "place".
TEST(RobotPlacement, IsAChangeOfRobotsBallAndBodies) {
  const auto file = fixtures::write_scene(
      "[ball]\nposition = [0.5, 0]\n[[robots]]\nname = 'one'\nmodel = 'kid21'\ncontroller = 'none'\n"
      "[[bodies]]\nname = 'crate'\nshape = 'box'\nsize = [0.2, 0.2, 0.2]\nmass = 1\nposition = [0, 1, 0]\n");
  Scene scene(file, {.events = {"0.3:ball.place=[1.5, -0.5]", "0.3:one.place=[-1, 0.25, 0, 1.5]"}, .cameras = false});
  scene.simulation().run(200ms);
  auto done = scene.post("crate.place = [2, 1, 0.5]");
  scene.simulation().run(10ms);
  done.get();
  const auto at = [&](const std::string& name) {
    return scene.simulation().world().entity(name).base().get(properties::position);
  };
  EXPECT_NEAR(at("crate").x, 2, 1e-9);
  EXPECT_GT(at("crate").z, 0.55) << "the lowest point is at 0.5 m and falls";
  scene.simulation().run(790ms);
  EXPECT_NEAR(at("ball").x, 1.5, 0.01);
  EXPECT_NEAR(at("ball").y, -0.5, 0.01);
  EXPECT_NEAR(at("one").x, -1, 0.02);
  EXPECT_NEAR(at("one").y, 0.25, 0.02);
  EXPECT_LT(at("crate").z, 0.12) << "it has fallen";
  const auto wrong = [&](const std::string& change) {
    auto refused = scene.post(change);
    scene.simulation().run(1ms);
    return fixtures::error_of([&] { refused.get(); });
  };
  for (const char* change : {"ball.place=[1]", "one.place=[1, 2, 3, 4, 5]", "one.place=[1e6, 0]"}) {
    EXPECT_TRUE(fixtures::says(wrong(change), {"write [x, y], [x, y, z] (m) or [x, y, z, heading] (rad)"})) << change;
  }
  EXPECT_TRUE(fixtures::says(wrong("oen.place=[1, 2]"), {"oen", "one"}));
}

TEST(RobotPlacement, RefusesWhoIsNotThere) {
  Scene scene("walk", walker_at("full_dynamics"));
  scene.simulation().run(10ms);
  EXPECT_TRUE(fixtures::says(fixtures::error_of([&] { place(scene.parts(), "wolker", {}); }), {"wolker", "walker"}));
  scene.leave("walker");
  EXPECT_EQ(fixtures::error_of([&] { place(scene.parts(), "walker", {}); }),
            "walker is not there, so it is not placed");
}

}  // namespace
}  // namespace murosimf::scene
