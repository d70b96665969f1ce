// The pinned stance: the standing sole rests while joints move, feet swap when the other one lands, refusals name why.
#include "murosimf/dynamics/kinematic_walking.h"
#include "murosimf/collision/contact_properties.h"
#include "murosimf/dynamics/motion_properties.h"

#include <gtest/gtest.h>

#include "tests/fixtures.h"
#include "tests/physics/rig.h"

namespace murosimf::dynamics {
namespace {

using fixtures::difference;
using test::degree;
using test::Rig;

struct Walker {
  explicit Walker(const EntityOptions& options = {}, const catalog::LevelOptions& level = {}) {
    robot = &rig.add("robot", std::make_shared<const Model>(fixtures::two_legged()), options);
    rig.attach_motion(*robot, {.level = "kinematic_walking", .options = level});
    rig.simulation.initialize();
  }
  void want(const std::string& joint, double target) { robot->object(joint).set(properties::joint_target, target); }
  [[nodiscard]] Vec3d place(const char* name) { return robot->object(name).get(properties::position); }
  [[nodiscard]] Mat3d turn(const char* name) { return robot->object(name).get(properties::orientation); }
  [[nodiscard]] double stance() { return robot->base().get(properties::stance_foot); }
  Rig rig;
  Entity* robot = nullptr;
};

/// The right leg bends and lifts its foot, flat; the left one, which stands, leans.
void lift_right(Walker& walker) {
  walker.want("right_hip_pitch", -0.5);
  walker.want("right_knee", 0.9);
  walker.want("right_ankle", -0.5);
  walker.want("left_hip_pitch", -0.1);
}

TEST(KinematicStance, StartsOnItsSolesAboveItsPlace) {
  Walker walker({.position = {1, -2, 0}, .heading = 0.5});
  EXPECT_NEAR(walker.place("left_foot").z, 0, 1e-12);
  EXPECT_NEAR(walker.place("right_foot").z, 0, 1e-12);
  EXPECT_LT(difference(walker.turn("left_foot"), rotation_z(0.5)), 1e-12);
  EXPECT_LT(difference(Rig::place(*walker.robot), {1, -2, 0.31}), 1e-12);
  EXPECT_EQ(walker.robot->base().get(properties::dynamic), 0);
}

TEST(KinematicStance, StartsInThePostureOfItsTargets) {
  Rig rig;
  Entity& robot = rig.add("robot", std::make_shared<const Model>(fixtures::two_legged()));
  rig.attach_motion(robot, {.level = "kinematic_walking"});
  for (const char* knee : {"left_knee", "right_knee"}) robot.object(knee).set(properties::joint_target, 0.8);
  rig.simulation.initialize();
  for (const char* knee : {"left_knee", "right_knee"}) {
    EXPECT_EQ(robot.object(knee).get(properties::joint_position), 0.8);
    EXPECT_EQ(robot.object(knee).get(properties::joint_velocity), 0);
  }
}

// The standing sole does not move; everything else does, as the velocities say: one step of the joints at a time.
TEST(KinematicStance, StandingSoleRestsAndVelocitiesAreThoseOfThePlaces) {
  Walker walker({.heading = 0.8});
  lift_right(walker);
  const Vec3d stood = walker.place("left_foot");
  const Mat3d turned = walker.turn("left_foot");
  double fastest = 0;
  for (int i = 0; i < 200; ++i) {
    const Vec3d trunk = Rig::place(*walker.robot), foot = walker.place("right_foot");
    const Mat3d R = walker.robot->base().get(properties::orientation);
    walker.rig.simulation.step();
    ASSERT_EQ(walker.stance(), 0);
    EXPECT_LT(difference(walker.place("left_foot"), stood), 1e-12);
    EXPECT_LT(difference(walker.turn("left_foot"), turned), 1e-12);
    EXPECT_LT(norm(walker.robot->object("left_foot").get(properties::linear_velocity)), 1e-12);
    EXPECT_LT(norm(walker.robot->object("left_foot").get(properties::angular_velocity)), 1e-12);
    // velocities after the step against the way of the step: off by half a step's acceleration
    const Vec3d v = walker.robot->base().get(properties::linear_velocity);
    const Vec3d w = walker.robot->base().get(properties::angular_velocity);
    EXPECT_LT(difference(v, 1e3 * (Rig::place(*walker.robot) - trunk)), 5e-3) << i;
    EXPECT_LT(difference(w, 1e3 * rotation_vector(
                                      from_matrix(walker.robot->base().get(properties::orientation) * transpose(R)))),
              2e-2)
        << i;
    EXPECT_LT(difference(walker.robot->object("right_foot").get(properties::linear_velocity),
                         1e3 * (walker.place("right_foot") - foot)),
              6e-2)
        << i;
    fastest = std::max(fastest, norm(v));
  }
  EXPECT_GT(fastest, 0.1);
  EXPECT_GT(walker.place("right_foot").z, 0.02);
}

// The other leg gets longer than the one that stands: it lands where it is, with its own heading, and stands from then on.
TEST(KinematicStance, OtherFootStandsWhereItLands) {
  Walker walker({.heading = 0.3});
  EXPECT_EQ(walker.stance(), 0);
  for (const char* joint : {"left_hip_pitch", "left_knee", "left_ankle"}) {
    walker.want(joint, std::string(joint) == "left_knee" ? 0.8 : -0.4);
  }
  Vec3d before = walker.place("right_foot");
  for (int i = 0; i < 100 && walker.stance() == 0; ++i) {
    before = walker.place("right_foot");
    walker.rig.simulation.step();
  }
  ASSERT_EQ(walker.stance(), 1);
  EXPECT_NEAR(walker.place("right_foot").x, before.x, 2e-3);
  EXPECT_NEAR(walker.place("right_foot").y, before.y, 2e-3);
  EXPECT_NEAR(walker.place("right_foot").z, 0, 1e-4) << "the way of a step";
  const Vec3d landed = walker.place("right_foot");
  walker.rig.run(3);
  EXPECT_EQ(walker.stance(), 1);
  EXPECT_LT(difference(walker.place("right_foot"), {landed.x, landed.y, 0}), 1e-12);
  EXPECT_GT(walker.place("left_foot").z, 0.005);
  EXPECT_NEAR(walker.robot->base().get(properties::stance_pose).z, 0.3, 1e-6);
}

// A foot that lands tilted keeps its place and turns flat in the course of 0.1 s: the base goes where its velocity says.
TEST(KinematicStance, FootThatLandsTiltedTurnsFlatSlowly) {
  Walker walker({.heading = 0.3});
  walker.want("right_hip_pitch", -0.2);
  walker.want("right_knee", 0.4);
  walker.want("right_ankle", -0.14);
  walker.rig.run(0.2);
  ASSERT_EQ(walker.stance(), 0);
  walker.want("left_hip_pitch", -0.4);
  walker.want("left_knee", 0.8);
  walker.want("left_ankle", -0.4);
  Vec3d before = Rig::place(*walker.robot), v = walker.robot->base().get(properties::linear_velocity);
  double largest = 0;
  const auto watch = [&] {
    walker.rig.simulation.step();
    const Vec3d r = Rig::place(*walker.robot), now = walker.robot->base().get(properties::linear_velocity);
    largest = std::max(largest, norm(r - before - 0.5e-3 * (v + now)));
    before = r;
    v = now;
  };
  for (int i = 0; i < 100 && walker.stance() == 0; ++i) watch();
  ASSERT_EQ(walker.stance(), 1);
  const Vec3d landed = walker.place("right_foot");
  EXPECT_GT(norm(walker.robot->base().get(properties::remaining_turn)), 5e-3) << "it is not flat yet";
  for (int i = 0; i < 2000; ++i) watch();
  EXPECT_LT(largest, 0.3e-3);
  EXPECT_EQ(walker.stance(), 1);
  EXPECT_LT(difference(walker.place("right_foot"), {landed.x, landed.y, 0}), 1e-6) << "where it has landed";
  EXPECT_NEAR(walker.turn("right_foot").z.z, 1, 1e-12);
}

// Two soles that cannot both be flat: when one is, the other one is below the plane.
TEST(KinematicStance, FeetThatAreNotParallelDoNotTakeTurnsInEveryStep) {
  Walker walker;
  walker.want("right_ankle", 0.05);
  int swaps = 0;
  for (int i = 0; i < 1000; ++i) {
    const double foot = walker.stance();
    walker.rig.simulation.step();
    swaps += walker.stance() != foot;
  }
  EXPECT_LT(swaps, 30) << "each stands for tens of milliseconds";
}

TEST(KinematicStance, WhoeverMovesTheBaseMovesTheStandingFoot) {
  Walker walker({.heading = 0.3});
  const Vec3d foot = walker.place("left_foot"), base = Rig::place(*walker.robot);
  walker.robot->base().set(properties::position, base + Vec3d{0.2, -0.1, 0.7});
  walker.rig.simulation.step();
  EXPECT_LT(difference(walker.place("left_foot"), foot + Vec3d{0.2, -0.1, 0}), 1e-12) << "it stays on the plane";
  walker.rig.simulation.step();
  EXPECT_LT(difference(Rig::place(*walker.robot), base + Vec3d{0.2, -0.1, 0}), 1e-12);
  walker.robot->base().set(properties::separation, {0.001, -0.002, 0.5});
  walker.rig.simulation.step();
  EXPECT_LT(difference(walker.place("left_foot"), foot + Vec3d{0.201, -0.102, 0}), 1e-12);
}

// Whatever freezes it: nothing that stands in the columns moves any more.
TEST(KinematicStance, WhatIsFrozenRests) {
  for (const bool far : {false, true}) {
    Walker walker;
    lift_right(walker);
    walker.rig.run(0.05);
    ASSERT_GT(norm(walker.robot->base().get(properties::linear_velocity)), 5e-3);
    if (far) walker.robot->base().set(properties::position, {9e5, 9e5, 0});
    if (!far) walker.want("left_knee", std::nan(""));
    walker.rig.simulation.step();
    ASSERT_TRUE(walker.robot->frozen());
    for (const Vec3d& v : walker.robot->column(properties::linear_velocity).values) EXPECT_EQ(norm(v), 0) << far;
    for (const Vec3d& w : walker.robot->column(properties::angular_velocity).values) EXPECT_EQ(norm(w), 0) << far;
    for (const double rate : walker.robot->column(properties::joint_velocity).values) EXPECT_EQ(rate, 0) << far;
  }
}

TEST(KinematicStance, TargetsThatAreNoNumbersFreezeIt) {
  Walker walker;
  walker.want("left_knee", std::nan(""));
  walker.rig.simulation.step();
  ASSERT_TRUE(walker.robot->frozen());
  EXPECT_TRUE(fixtures::says(*walker.robot->frozen_reason(), {"target is no sensible number"}));
  EXPECT_EQ(norm(walker.robot->base().get(properties::linear_velocity)), 0);
  Walker far;
  far.robot->base().set(properties::position, {9e5, 9e5, 0});
  far.rig.simulation.step();
  EXPECT_TRUE(far.robot->frozen());
}

// Rule: a robot that is taken over stands on its lower foot where that is, and comes down to its pinned pose from where it was.
TEST(KinematicTakeOver, StandsOnTheLowerFootWhereItIs) {
  for (const bool left_up : {true, false}) {
    Rig rig;
    rig.simulation.world().gravity = {};
    Entity& robot = rig.add("robot", std::make_shared<const Model>(fixtures::two_legged()),
                            {.position = {3, -4, 0.003}, .heading = 0.7});
    rig.attach_dynamics(robot, {.on_ground = false});
    const std::string side = left_up ? "left" : "right", lower = left_up ? "right_foot" : "left_foot";
    robot.object(side + "_hip_pitch").set(properties::joint_target, -0.2);
    robot.object(side + "_knee").set(properties::joint_target, 0.4);
    robot.object(side + "_ankle").set(properties::joint_target, -0.2);
    rig.simulation.initialize();
    const Vec3d foot = robot.object(lower).get(properties::position), place = Rig::place(robot);
    ASSERT_NEAR(foot.z, 0.003, 1e-9);
    robot.base().set(properties::linear_velocity, {0.1, 0.2, -0.3});
    robot.base().set(properties::angular_velocity, {0.3, -0.2, 0.1});
    for (const char* knee : {"left_knee", "right_knee"}) robot.object(knee).set(properties::joint_velocity, 0.5);
    rig.exchange(robot, "kinematic_walking");
    EXPECT_EQ(robot.base().get(properties::stance_foot), left_up ? 1 : 0);
    EXPECT_LT(difference(robot.base().get(properties::stance_pose), {foot.x, foot.y, 0.7}), 1e-9);
    EXPECT_LT(difference(robot.base().get(properties::remaining_shift), {0, 0, 0.003}), 1e-9);
    EXPECT_LT(difference(Rig::place(robot), place), 1e-9) << "no jump";
    EXPECT_LT(difference(robot.base().get(properties::linear_velocity), {0.1, 0.2, -0.3}), 1e-12) << "no jump";
    EXPECT_LT(difference(robot.base().get(properties::angular_velocity), {0.3, -0.2, 0.1}), 1e-12);
    rig.run(0.2);
    EXPECT_LT(norm(robot.object(lower).get(properties::linear_velocity)), 0.02) << "it comes to rest";
    rig.run(2);
    EXPECT_LT(difference(robot.object(lower).get(properties::position), {foot.x, foot.y, 0}), 1e-6);
  }
}

/// What it says to a robot that leans by `lean` [degree] about a slanted axis, `height` [m] above the plane.
std::string refusal(double lean, double height) {
  Rig rig;
  rig.simulation.world().gravity = {};
  Entity& robot =
      rig.add("robot", std::make_shared<const Model>(fixtures::two_legged()),
              {.position = {0, 0, height}, .attitude = to_matrix(exponential(lean * degree * Vec3d{0.6, -0.8, 0}))});
  rig.attach_dynamics(robot, {.on_ground = false});
  rig.simulation.initialize();
  return fixtures::error_of([&] { rig.exchange(robot, "kinematic_walking"); });
}

TEST(KinematicRefusal, IsAtThirtyDegreesAndTwentyMillimeters) {
  EXPECT_EQ(refusal(0, 0.0195), "no error");
  EXPECT_TRUE(fixtures::says(refusal(0, 0.0205), {"21 mm away", "more than 20"}));
  EXPECT_EQ(refusal(0, -0.0195), "no error");
  EXPECT_TRUE(fixtures::says(refusal(0, -0.0205), {"mm away"}));
  EXPECT_EQ(refusal(29.5, 0.0), "no error");
  EXPECT_TRUE(fixtures::says(refusal(30.5, 0.0), {"leans 31 degrees", "more than 30"}));
}

TEST(KinematicRefusal, ModelsNeedTwoSoles) {
  const auto with = [](int soles) {
    Chain chain = Chain{}.base("base").with(properties::mass, 1.0);
    for (int i = 0; i < soles; ++i) chain.translation({0, 0, -0.1}).with(properties::sole, {0.1, 0.1});
    return fixtures::error_of([&] {
      Simulation simulation;
      Entity& robot = simulation.world().add("robot", std::make_shared<const Model>("odd", chain));
      simulation.attach<KinematicWalking>("kinematic_walking", robot, 1000);
    });
  };
  EXPECT_EQ(with(2), "no error");
  EXPECT_TRUE(fixtures::says(with(1), {"model 'odd'", "1 sole, not 2"}));
  EXPECT_TRUE(fixtures::says(with(3), {"3 soles, not 2"}));
  EXPECT_TRUE(fixtures::says(with(0), {"0 soles"}));
}

}  // namespace
}  // namespace murosimf::dynamics
