// What an MJCF file says of a robot's start and its controls acts at every level, and what has no effect is named by the run.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "murosimf/model/properties.h"
#include "murosimf/scene/scene.h"
#include "murosimf/scene/scene_report.h"
#include "tests/written_scene.h"

namespace murosimf::scene {
namespace {

/// A heavy base that hangs in the air with an arm; `joint` and `rest` are put into the file.
std::string robot(const std::string& joint, const std::string& rest) {
  const std::string file =
      (fixtures::temp_folder() / (std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + ".xml"))
          .string();
  std::ofstream(file) << R"(<mujoco model="arm"><compiler angle="radian"/><worldbody><body name="base" pos="0 0 1">
    <geom type="box" size=".1 .1 .1" mass="3"/><freejoint/>
    <body name="arm" pos="0 0 .3"><joint name="j" axis="0 1 0" )"
                      << joint
                      << R"(/><inertial pos="0 0 -.1" mass="1" diaginertia=".01 .01 .01"/></body></body></worldbody>)"
                      << rest << "</mujoco>";
  return file;
}

std::string scene_with(const std::string& file, const std::string& keys) {
  return "duration = 2\nrate = 1000\n[field]\ngoals = false\n[[robots]]\nname = \"a\"\ncontroller = \"none\"\nmodel = "
         "\"" +
         file + "\"\nposition = [0, 0, 1]\n" + keys;
}

double angle(Scene& scene) {
  return scene.simulation().world().entity("a").object("j").get(properties::joint_position);
}

void want(Scene& scene, double target) {
  scene.simulation().world().entity("a").object("j").set(properties::joint_target, target);
}

const std::vector<std::string> all_levels{"simplified_dynamics", "full_dynamics", "articulated_dynamics"};

TEST(WhatTheFileSays, ACtrlrangeHoldsTargetsAtEveryLevel) {
  const std::string file =
      robot(R"(range="-2 2")", R"(<actuator><position joint="j" kp="300" kv="10" ctrlrange="-.2 .3"/></actuator>)");
  for (const std::string& level : all_levels) {
    Scene scene(fixtures::write_scene(
        scene_with(file, "fixed_base = " + std::string(level == "simplified_dynamics" ? "false" : "true") +
                             "\nlevel = \"" + level + "\"\n")));
    scene.simulation().initialize();
    for (const auto& [target, reached] : {std::pair{0.9, 0.3}, {-0.9, -0.2}, {0.1, 0.1}}) {
      want(scene, target);
      scene.simulation().run(std::chrono::milliseconds(1000));
      EXPECT_NEAR(angle(scene), reached, 0.01) << level << ", target " << target;  // servos sag
    }
  }
}

TEST(WhatTheFileSays, ACtrlrangeHoldsRates) {
  const std::string file = robot("", R"(<actuator><velocity joint="j" kv="5" ctrlrange="-1 .5"/></actuator>)");
  for (const std::string& level : all_levels) {
    Scene scene(fixtures::write_scene(scene_with(file, "level = \"" + level + "\"\n")));
    scene.simulation().initialize();
    auto arm = scene.simulation().world().entity("a").object("j");
    arm.set(properties::joint_velocity_target, 9.0);
    scene.simulation().run(std::chrono::milliseconds(400));
    EXPECT_NEAR(arm.get(properties::joint_velocity), 0.5, 0.05) << level;
  }
}

TEST(WhatTheFileSays, ARobotStartsInThePoseOfTheFile) {
  const std::string file =
      robot(R"(range=".2 2" ref=".8")", R"(<actuator><position joint="j" kp="300" kv="10"/></actuator>)");
  for (const std::string& level : all_levels) {
    Scene scene(fixtures::write_scene(scene_with(file, "level = \"" + level + "\"\n")));
    scene.simulation().initialize();
    EXPECT_EQ(angle(scene), 0.8) << level;
    scene.simulation().run(std::chrono::milliseconds(10));
    EXPECT_NEAR(angle(scene), 0.8, 0.01) << level;
    scene.simulation().reset();
    EXPECT_EQ(angle(scene), 0.8) << level << ", once more";
  }
}

TEST(WhatTheFileSays, ARobotStartsAtAKeyframeThatTheSceneNames) {
  const std::string file = robot(R"(range="-2 2")", R"(<actuator><position joint="j" kp="300" kv="10"/></actuator>
    <keyframe><key name="home" qpos="5 6 7 0 1 0 0 .4"/><key name="reach" qpos="0 0 1 1 0 0 0 -.3" ctrl=".6"/></keyframe>)");
  const auto start = [&](const std::string& keys) {
    auto scene =
        std::make_unique<Scene>(fixtures::write_scene(scene_with(file, "level = \"articulated_dynamics\"\n" + keys)));
    scene->simulation().initialize();
    return scene;
  };
  EXPECT_EQ(angle(*start("")), 0.0);
  const auto home = start("keyframe = \"home\"\n");
  EXPECT_EQ(angle(*home), 0.4);
  const Mat3d R = home->simulation().world().entity("a").base().get(properties::orientation);
  EXPECT_NEAR(R.z.z, -1, 1e-12);  // half a turn about x
  const auto reach = start("keyframe = \"reach\"\nfixed_base = true\n");
  EXPECT_EQ(angle(*reach), -0.3);
  reach->simulation().run(std::chrono::milliseconds(1000));
  EXPECT_NEAR(angle(*reach), 0.6, 0.02);
  try {
    (void)start("keyframe = \"hom\"\n");
    FAIL() << "took an unknown keyframe";
  } catch (const SetupError& error) {
    EXPECT_NE(std::string(error.what()).find("unknown keyframe 'hom'"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("home"), std::string::npos) << error.what();
  }
}

TEST(WhatTheFileSays, TorquesMayDifferByDirection) {
  const std::string file =
      robot("", R"(<actuator><position joint="j" kp="1e4" kv="100" forcerange="-1 3"/></actuator>)");
  Scene scene(fixtures::write_scene(scene_with(file, "level = \"articulated_dynamics\"\nfixed_base = true\n")));
  scene.simulation().initialize();
  auto arm = scene.simulation().world().entity("a").object("j");
  want(scene, 1.5);
  scene.simulation().run(std::chrono::milliseconds(5));
  EXPECT_NEAR(arm.get(properties::joint_torque), 3, 1e-9);
  want(scene, -1.5);
  scene.simulation().run(std::chrono::milliseconds(5));
  EXPECT_NEAR(arm.get(properties::joint_torque), -1, 1e-9);
}

TEST(WhatTheFileSays, ARunNamesWordsWithoutEffect) {
  const std::string file = robot("", R"(<option gravity="0 0 -1"/><deformable/>)");
  Scene scene(fixtures::write_scene(scene_with(file, "level = \"full_dynamics\"\n")), {.lenient = true});
  const auto notes = make_report(scene).notes;
  ASSERT_EQ(std::ranges::count_if(notes,
                                  [](const std::string& note) {
                                    return note.find("have no effect here: option; murosimf check ") !=
                                           std::string::npos;
                                  }),
            1);
  EXPECT_TRUE(std::ranges::any_of(make_report(scene).warnings, [](const std::string& warning) {
    return warning.find("element 'deformable' is not supported") != std::string::npos;
  }));
}

}  // namespace
}  // namespace murosimf::scene
