// Scenes share what was read, with no effect but on the time it takes.
#include "murosimf/scene/assets.h"

#include <algorithm>
#include <fstream>
#include <thread>

#include <gtest/gtest.h>

#include "murosimf/files/child_process.h"
#include "murosimf/model/error.h"
#include "murosimf/scene/scene.h"
#include "tests/fixtures.h"
#include "tests/scene/scene_hashes.h"
#include "tests/written_scene.h"

namespace murosimf::scene {
namespace {

using namespace std::chrono_literals;

const char* const walker = "[defaults]\nmodel = 'kid21'\ncontroller = 'walk'\n[[robots]]\nname = 'one'\n";

TEST(Assets, ScenesHaveTheSameModel) {
  const std::string file = fixtures::write_scene(walker);
  const auto assets = std::make_shared<Assets>();
  const Scene a(file, {.assets = assets}), b(file, {.assets = assets}), alone(file);
  const auto model = [](const Scene& scene) { return scene.simulation().world().entity("one").model_ptr(); };
  EXPECT_EQ(model(a), model(b));
  EXPECT_NE(model(a), model(alone));
}

// Fields that differ in anything, or that carry bodies, are models of their own.
TEST(Assets, ScenesOfEqualFieldsShareTheModel) {
  const auto assets = std::make_shared<Assets>();
  const auto field = [&](const std::string& text, const std::vector<std::string>& overrides = {}) {
    const Scene scene(fixtures::write_scene(text + walker), {.overrides = overrides, .assets = assets});
    return scene.simulation().world().entity("field").model_ptr();
  };
  const ModelPtr usual = field("");
  EXPECT_EQ(field("duration = 3\n"), usual);
  const std::vector<ModelPtr> others{
      field("", {"field.surface=grass"}),
      field("", {"field.size=kid_size_2023"}),
      field("", {"field.goals=false"}),
      field("", {"field.landmark_poles=true"}),
      field("[field]\nfriction_direction = [1, 0, 0]\n"),
      field("[[bodies]]\nname = 'step'\nshape = 'box'\nsize = [1, 1, 1]\nstatic = true\n")};
  for (const ModelPtr& other : others) {
    EXPECT_NE(other, usual);
    EXPECT_EQ(std::count(others.begin(), others.end(), other), 1);
  }
}

TEST(Assets, ChangedConstantsStayWithTheirScene) {
  const std::string file = fixtures::write_scene(walker);
  const auto assets = std::make_shared<Assets>();
  const Scene changed(file, {.overrides = {"one.pelvis.mass=3"}, .assets = assets}), usual(file, {.assets = assets});
  const auto mass = [](const Scene& scene) { return scene.simulation().world().entity("one").model().tree().mass; };
  const Scene alone(file);
  EXPECT_EQ(mass(usual), mass(alone));
  EXPECT_NE(mass(changed), mass(usual));
}

TEST(Assets, AScenePutTogetherInMemoryIsThatOfItsFile) {
  const std::string file = fixtures::write_scene(walker);
  const auto assets = std::make_shared<Assets>();
  Scene of_file(file, {.cameras = false, .assets = assets}),
      of_memory(of_file.spec(), {.cameras = false, .assets = assets});
  for (Scene* scene : {&of_file, &of_memory}) scene->simulation().initialize();
  EXPECT_EQ(difference(go_on(of_file, 100ms), go_on(of_memory, 100ms)), "");
  scene_file::SceneSpec spec = of_file.spec();
  spec.robots[0].position = {1, 2, 0};
  Scene moved(spec, {.cameras = false, .assets = assets});
  moved.simulation().initialize();
  EXPECT_NEAR(moved.simulation().world().entity("one").options().position.y, 2, 1e-12);
}

TEST(Assets, WhatCannotBeReadIsTriedAgain) {
  Assets assets;
  const auto file = fixtures::temp_folder() / "broken_asset.xml";
  std::ofstream(file) << "<mujoco";
  EXPECT_THROW((void)assets.robot(file, {}), SetupError);
  std::ofstream(file)
      << "<mujoco><worldbody><body><freejoint/><geom type='sphere' size='0.1' mass='1'/></body></worldbody></mujoco>";
  EXPECT_EQ(assets.robot(file, {})->model->bodies().size(), 1u);
}

// Two robots of one file, and what cannot be meant.
TEST(Assets, BodiesChooseAmongTheRobotsOfAFile) {
  const auto folder = fixtures::temp_folder();
  std::ofstream(folder / "two_robots.xml") << "<mujoco><worldbody><body name='a'><freejoint/><geom size='0.1' "
                                              "mass='1'/></body><body name='b'><freejoint/><geom "
                                              "size='0.1' mass='2'/></body></worldbody></mujoco>";
  const auto robot = [&](const std::string& name, const std::string& more) {
    return "[[robots]]\nname = '" + name + "'\nmodel = '" + (folder / "two_robots.xml").string() +
           "'\nlevel = 'simplified_dynamics'\ncontroller = 'none'\n" + more;
  };
  Scene scene(fixtures::write_scene(robot("first", "") + robot("second", "body = 'b'\nposition = [1, 0]\n")));
  const World& world = scene.simulation().world();
  EXPECT_EQ(world.entity("first").model().tree().mass, 1);
  EXPECT_EQ(world.entity("second").model().tree().mass, 2);
  const auto complaint = [&](const std::string& more) {
    return fixtures::error_of([&] { Scene wrong(fixtures::write_scene(robot("first", more))); });
  };
  EXPECT_TRUE(fixtures::says(complaint("body = 'c'\n"), {"unknown body 'c'"}));
  EXPECT_TRUE(fixtures::says(complaint("xacro = {side = 'left'}\n"), {"it is no .xacro file"}));
  EXPECT_TRUE(
      fixtures::says(complaint("xacro = {side = [1]}\n"), {"arguments of xacro are texts, numbers, true or false"}));
}

TEST(Assets, ArgumentsOfXacroReachTheFile) {
  const auto python = files::run_process({"python3", "-c", "import xacro"}, "");
  if (!python || python->exit_code != 0) GTEST_SKIP() << "python3 has no package xacro: pip install xacro";
  const auto file = fixtures::temp_folder() / "weighed.xacro";
  std::ofstream(file)
      << "<robot name='r' xmlns:xacro='http://ros.org/wiki/xacro'><xacro:arg name='mass' default='2'/><link "
         "name='base'><inertial><mass value='$(arg mass)'/><inertia ixx='1' iyy='1' izz='1'/></inertial><collision>"
         "<geometry><sphere radius='0.1'/></geometry></collision></link></robot>";
  Scene scene(fixtures::write_scene("[[robots]]\nname = 'a'\nmodel = '" + file.string() +
                                    "'\nlevel = 'simplified_dynamics'\ncontroller = 'none'\nxacro = {mass = 3.5}\n"));
  EXPECT_EQ(scene.simulation().world().entity("a").model().tree().mass, 3.5);
}

TEST(Assets, ManyThreadsBuildWithTheSame) {
  const std::string file = fixtures::write_scene(walker);
  const auto assets = std::make_shared<Assets>();
  std::vector<std::uint64_t> hashes(4);
  std::vector<std::thread> threads;
  for (std::uint64_t& hash : hashes) {
    threads.emplace_back([&] {
      Scene scene(file, {.cameras = false, .assets = assets});
      scene.simulation().run(50ms);
      hash = scene.simulation().state_hash();
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const std::uint64_t hash : hashes) EXPECT_EQ(hash, hashes[0]);
}

}  // namespace
}  // namespace murosimf::scene
