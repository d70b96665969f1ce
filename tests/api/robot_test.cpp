// include/murosimf/world.h, robot.h and control.h: poses, joints and commands against the columns inside and against laws.
#include "murosimf/robot.h"

#include <gtest/gtest.h>

#include <cmath>

#include "murosimf/model/properties.h"
#include "murosimf/scene.h"
#include "murosimf/scene/scene.h"

namespace murosimf::api {
namespace {

constexpr double g = 9.81;

template <class E, class Call>
std::string thrown_text(const Call& call) {
  try {
    call();
  } catch (const E& error) {
    return error.what();
  }
  return {};
}

Scene standing(const std::string& level = "simplified_dynamics") {
  return Scene("walk", {.set = {"walker.controller=none", "walker.level=" + level}});
}

TEST(ApiEntity, PosesAreThoseOfTheColumns) {
  scene::Scene truth("walk", {.overrides = {"walker.level=full_dynamics"}});
  truth.simulation().run(std::chrono::milliseconds(700));
  Scene scene("walk", {.set = {"walker.level=full_dynamics"}});
  scene.run(0.7);
  const Robot robot = scene.robot("walker");
  Entity& inside = truth.simulation().world().entity("walker");
  for (const std::string& object : robot.objects()) {
    const Vec3d r = inside.object(object).get(properties::position);
    const Mat3d R = inside.object(object).get(properties::orientation);
    const Pose pose = robot.pose(object);
    EXPECT_EQ(pose.position, (Vector3{r.x, r.y, r.z})) << object;
    const Rotation& q = pose.orientation;
    EXPECT_NEAR(1 - 2 * (q.y * q.y + q.z * q.z), R.x.x, 1e-12);
    EXPECT_NEAR(2 * (q.x * q.y + q.w * q.z), R.x.y, 1e-12);
    EXPECT_NEAR(2 * (q.y * q.z - q.w * q.x), R.z.y, 1e-12) << "w first, body axes to world axes";
    const Vec3d w = inside.object(object).get(properties::angular_velocity);
    EXPECT_EQ(robot.velocity(object).angular, (Vector3{w.x, w.y, w.z}));
  }
  EXPECT_EQ(robot.pose(), robot.pose(robot.objects()[0]));
}

TEST(ApiEntity, ABallThatIsThrownFliesAParabola) {
  Scene scene = Scene::of_text(
      "[air]\ndensity = 0\n[[bodies]]\nname = \"stone\"\nshape = \"sphere\"\nradius = 0.05\nmass = 1.0\ndrag = "
      "0.0\nlift = 0.0\n");
  EntityHandle stone = scene.entity("stone");
  stone.set_pose({{1, 2, 3}, {}});
  stone.set_velocity({{1, -2, 0.5}, {}});
  scene.run(0.5);
  const double t = 0.5, h = 1e-3;
  const Vector3 r = stone.pose().position;
  EXPECT_NEAR(r.x, 1 + t, 1e-9);
  EXPECT_NEAR(r.y, 2 - 2 * t, 1e-9);
  EXPECT_NEAR(r.z, 3 + 0.5 * t - 0.5 * g * t * t, g * t * h);  // semi-implicit: at most g t h beside it
  EXPECT_NEAR(stone.velocity().linear.z, 0.5 - g * t, 1e-9);
}

TEST(ApiEntity, APushGivesItsImpulse) {
  Scene scene = Scene::of_text(
      "[air]\ndensity = 0\n[[bodies]]\nname = \"stone\"\nshape = \"sphere\"\nradius = 0.05\nmass = 2.0\nposition = "
      "[0.0, 0.0, 5.0]\ndrag = "
      "0.0\nlift = 0.0\n");
  EntityHandle stone = scene.entity("stone");
  stone.push("", {30, -4, 0}, 0.1);
  scene.run(0.3);
  EXPECT_NEAR(stone.velocity().linear.x, 30 * 0.1 / 2, 1e-9);
  EXPECT_NEAR(stone.velocity().linear.y, -4 * 0.1 / 2, 1e-9);
  Scene walk("walk");
  EXPECT_NE(thrown_text<InputError>([&] { walk.robot().push("torso", {1, 0, 0}, 0.1); }), "") << "kinematic: no forces";
  EXPECT_NE(thrown_text<UnknownName>([&] { walk.robot().push("tors", {1, 0, 0}, 0.1); }), "");
}

TEST(ApiEntity, IsPlacedUprightAndAtRest) {
  Scene scene = standing();
  Robot robot = scene.robot();
  scene.run(0.5);
  robot.place({1, -0.5, 0}, 0.7);
  const Pose pose = robot.pose();
  EXPECT_NEAR(pose.position.x, 1, 1e-9);
  EXPECT_NEAR(pose.position.y, -0.5, 1e-9);
  EXPECT_NEAR(2 * std::atan2(pose.orientation.z, pose.orientation.w), 0.7, 0.02);
  EXPECT_NE(thrown_text<InputError>([&] { robot.place({1e9, 0, 0}); }), "");
}

TEST(ApiEntity, PropertiesHaveTheirNames) {
  Scene scene = standing("articulated_dynamics");
  Robot robot = scene.robot();
  scene.run(0.05);
  const Vector3 head = robot.pose("head").position;
  EXPECT_EQ(robot.get("head", "position"), (std::vector{head.x, head.y, head.z}));
  EXPECT_EQ(robot.unit("head", "position"), "m");
  EXPECT_GT(robot.get("torso", "mass").at(0), 0) << "a constant of the model";
  const double force[] = {0, 0, 0, 5, 0, 0};
  robot.set("torso", "applied_force", force);
  EXPECT_EQ(robot.get("torso", "applied_force"), std::vector<double>(force, force + 6));
  EXPECT_NE(thrown_text<InputError>([&] { (void)robot.get("head", "positoin"); }).find("position"), std::string::npos);
  EXPECT_NE(thrown_text<InputError>([&] { robot.set("torso", "applied_force", std::span(force, 2)); }), "");
  EXPECT_NE(thrown_text<InputError>([&] { robot.set("torso", "mass", std::span(force, 1)); }), "");
}

TEST(ApiEntity, AViewIsTheMemoryItself) {
  Scene scene = standing();
  Robot robot = scene.robot();
  const PropertyView positions = robot.view("position");
  ASSERT_EQ(positions.rows, robot.objects().size());
  EXPECT_EQ(positions.shape[0], 3U);
  EXPECT_EQ(positions.unit, "m");
  scene.run(0.1);
  EXPECT_EQ(positions(0, 2), robot.pose().position.z);
  const double higher = positions(0, 2) += 0.25;
  scene.step();
  EXPECT_NEAR(robot.pose().position.z, higher, 1e-3) << "the level goes on from there";
}

TEST(ApiEntity, RefusesWhatIsNoPose) {
  Scene scene = standing();
  Robot robot = scene.robot();
  const std::uint64_t before = scene.state_hash();
  EXPECT_NE(thrown_text<InputError>([&] { robot.set_pose({{0, 0, NAN}, {}}); }).find("not finite"), std::string::npos);
  EXPECT_NE(thrown_text<InputError>([&] {
              robot.set_pose({{}, {0.5, 0, 0, 0}});
            }).find("unit quaternion"),
            std::string::npos);
  EXPECT_NE(thrown_text<InputError>([&] { robot.set_velocity({{INFINITY, 0, 0}, {}}); }), "");
  EXPECT_EQ(scene.state_hash(), before);
}

TEST(ApiRobot, JointsAreThoseOfTheModel) {
  Scene scene("walk");
  const Robot robot = scene.robot();
  scene::Scene truth("walk");
  Entity& inside = truth.simulation().world().entity("walker");
  truth.simulation().run(std::chrono::milliseconds(300));
  scene.run(0.3);
  ASSERT_EQ(robot.joints().size(), 21U);
  const std::span<const double> q = robot.joint_position();
  for (std::size_t i = 0; i < q.size(); ++i) {
    EXPECT_EQ(q[i], inside.object(robot.joints()[i].name).get(properties::joint_position));
    EXPECT_LT(robot.joints()[i].lower, robot.joints()[i].upper);
    EXPECT_EQ(robot.joints()[i].unit, "rad");
  }
  for (const double torque : robot.joint_torque()) EXPECT_TRUE(std::isnan(torque)) << "kinematic: there are none";
}

TEST(ApiRobot, JointsGoToTheirTargets) {
  Scene scene = Scene::of_robot("kid21", {.set = {"robot.level=simplified_dynamics"}});
  Robot robot = scene.robot();
  std::vector<double> targets(robot.joint_position().begin(), robot.joint_position().end());
  targets[0] += 0.2;
  robot.set_joint_target(targets);
  EXPECT_EQ(robot.joint_target()[0], targets[0]);
  scene.run(1.0);
  EXPECT_NEAR(robot.joint_position()[0], targets[0], 1e-3);
  targets.pop_back();
  EXPECT_NE(thrown_text<InputError>([&] { robot.set_joint_target(targets); }).find("takes 21 numbers, not 20"),
            std::string::npos);
  targets.push_back(NAN);
  EXPECT_NE(thrown_text<InputError>([&] { robot.set_joint_target(targets); }).find("number 20 is not finite"),
            std::string::npos);
}

TEST(ApiRobot, AWalkerTakesCommandsAndNoTargets) {
  Scene scene("walk", {.set = {"walker.command=[0, 0, 0]"}});
  Robot robot = scene.robot();
  scene.run(1.0);
  const double begin = robot.pose().position.x;
  robot.set_command(0.2, 0, 0);
  scene.run(3.0);
  EXPECT_GT(std::hypot(robot.pose().position.x - begin, 0.0), 0.2);
  const std::vector<double> zeros(robot.joints().size());
  EXPECT_NE(thrown_text<InputError>([&] { robot.set_joint_target(zeros); }).find("'none'"), std::string::npos);
  Scene still = standing();
  EXPECT_NE(thrown_text<InputError>([&] { still.robot().set_command(1, 0, 0); }), "");
}

TEST(ApiRobot, ItsLevelIsExchanged) {
  Scene scene("walk");
  Robot robot = scene.robot();
  scene.run(0.5);
  robot.set_level("articulated_dynamics");
  EXPECT_EQ(robot.level(), "articulated_dynamics");
  scene.run(0.2);
  for (const double torque : robot.joint_torque()) EXPECT_TRUE(std::isfinite(torque));
  EXPECT_NE(thrown_text<InputError>([&] { robot.set_level("articulated"); }).find("articulated_dynamics"),
            std::string::npos);
}

TEST(ApiRobot, LiesAfterAFall) {
  Scene scene = standing();
  Robot robot = scene.robot();
  EXPECT_FALSE(robot.fallen());
  robot.push("torso", {150, 0, 0}, 0.3);
  EXPECT_TRUE(scene.run_until([&] { return robot.fallen(); }, 5));
  EXPECT_EQ(robot.falls(), 1);
}

TEST(ApiRobot, PlaysMotionsOfItsFile) {
  Scene scene("walk", {.set = {"walker.controller=motions", "walker.level=full_dynamics"}});
  Robot robot = scene.robot();
  const std::vector<std::string> motions = robot.motions();
  ASSERT_FALSE(motions.empty());
  EXPECT_NE(thrown_text<UnknownName>([&] { robot.play("kick_with_the_ear"); }), "");
  scene.run(0.5);
  robot.play(motions[0]);
  ASSERT_FALSE(scene.events().empty());
  EXPECT_NE(scene.events().back().text.find(motions[0]), std::string::npos);
}

/// Swings one joint, and counts.
struct Swing final : Controller {
  int starts = 0, steps = 0;
  double throws_at = 1e9;  // [s]
  std::vector<double> times, seen;
  void start(ControlCycle&) override { ++starts; }
  void step(ControlCycle& cycle) override {
    if (cycle.time >= throws_at) throw std::domain_error("no such pose");
    ++steps;
    times.push_back(cycle.time);
    seen.push_back(cycle.joint_position[0]);
    cycle.joint_target[0] = 0.2 * std::sin(3 * cycle.time);
  }
};

TEST(ApiController, IsCalledAtItsRateBetweenSensorsAndMotion) {
  Scene scene = Scene::of_robot("kid21", {.set = {"robot.level=simplified_dynamics"}});
  Robot robot = scene.robot();
  const auto swing = std::make_shared<Swing>();
  robot.set_controller(swing, 50);
  scene.run(1.0);
  EXPECT_EQ(swing->starts, 1);
  ASSERT_EQ(swing->steps, 50);
  for (int i = 0; i < swing->steps; ++i) EXPECT_NEAR(swing->times[i], 0.02 * i, 1e-9);
  EXPECT_NEAR(robot.joint_target()[0], 0.2 * std::sin(3 * 0.98), 1e-12);
  EXPECT_NEAR(robot.joint_position()[0], robot.joint_target()[0], 0.05);
  EXPECT_NE(swing->seen.back(), swing->seen.front());
  EXPECT_NE(thrown_text<InputError>([&] { (void)scene.copy(); }).find("controller of the program"), std::string::npos);
  scene.reset();
  scene.run(0.1);
  EXPECT_EQ(swing->starts, 2);
  robot.set_controller(nullptr);
  const int steps = swing->steps;
  scene.run(0.2);
  EXPECT_EQ(swing->steps, steps);
}

TEST(ApiController, WhatItThrowsEndsTheStep) {
  Scene scene = Scene::of_robot("kid21", {.set = {"robot.level=simplified_dynamics"}});
  Robot robot = scene.robot();
  const auto swing = std::make_shared<Swing>();
  swing->throws_at = 0.3;
  robot.set_controller(swing, 100);
  EXPECT_THROW(scene.run(1.0), std::domain_error);
  EXPECT_NEAR(scene.time(), 0.301, 1e-9);
  const double target = robot.joint_target()[0];
  swing->throws_at = 1e9;
  scene.step();
  EXPECT_EQ(robot.joint_target()[0], target) << "its last targets hold until its next cycle";
  EXPECT_NE(thrown_text<InputError>([&] { robot.set_controller(std::make_shared<Swing>(), 0); }), "");
  const int steps = swing->steps;
  scene.run(0.1);
  EXPECT_GT(swing->steps, steps) << "the one before is still there";
  Scene walk("walk");
  EXPECT_NE(thrown_text<InputError>([&] { walk.robot().set_controller(swing); }).find("'none'"), std::string::npos);
}

}  // namespace
}  // namespace murosimf::api
