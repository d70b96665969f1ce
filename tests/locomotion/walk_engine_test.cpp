// From command to targets: ramps, limits, standing still again; and the small soccer player.
#include "murosimf/locomotion/walk_engine.h"

#include <gtest/gtest.h>

#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/soccer/ball_chaser.h"
#include "tests/law.h"
#include "tests/physics/rig.h"

namespace murosimf::locomotion {
namespace {

struct Walker {
  explicit Walker(const Vec3d& command) : robot(rig.add("robot", test::kid21())) {
    rig.simulation.attach<WalkEngine>("walk_engine", robot, 100, command);
    rig.simulation.attach<dynamics::KinematicWalking>("kinematic_walking", robot, 1000);
  }
  test::Rig rig;
  Entity& robot;
};

TEST(WalkEngine, StandsWithoutACommand) {
  Walker walker({});
  walker.rig.run(0.1);
  const double knee = walker.robot.object("j_l_shin").get(properties::joint_target);
  walker.rig.run(2.0);
  EXPECT_EQ(walker.robot.object("j_l_shin").get(properties::joint_target), knee);
  EXPECT_EQ(walker.robot.base().get(properties::gait_amplitude), 0);
}

TEST(WalkEngine, SlewsAndClipsTheCommand) {
  Walker walker({9, -9, 9});
  walker.rig.run(0.101);
  law::expect_near({.law = "walk command slews: speed after 11 control cycles",
                    .level = "walk_engine",
                    .source = "limit of 0.375 m/s^2 times 11 times 0.01 s"},
                   walker.robot.base().get(properties::gait_velocity).x, 11 * 0.01 * 0.375, 1e-9, "m/s");
  walker.rig.run(3.0);
  const WalkParameters p = seeded_parameters(find_legs(*test::kid21())), kept = seeded_parameters(*test::kid21());
  EXPECT_EQ(kept.hip_height, p.hip_height);
  EXPECT_EQ(kept.sway, p.sway);
  const Vec3d v = walker.robot.base().get(properties::gait_velocity);
  EXPECT_EQ(v.x, p.fastest.x);
  EXPECT_EQ(v.y, -p.fastest.y);
  EXPECT_EQ(v.z, p.fastest.z);
}

/// kid21 with joints that are no faster than this [rad/s].
Model with_rates(double most) {
  const ModelPtr model = test::kid21();
  ConstantTable constants = model->constants();
  for (const int joint : model->joints()) constants.set(properties::joint_rate_limit, joint, most);
  return model->with(std::move(constants));
}

/// [rad/s] The fastest hinge in a period.
double fastest_hinge(const std::array<Leg, 2>& legs, const WalkParameters& p, const Vec3d& velocity) {
  constexpr int steps = 1000;
  double fastest = 0;
  for (int i = 0; i < steps; ++i) {
    const GaitPose a = gait_pose(legs, p, 2 * pi * i / steps, 1, velocity),
                   b = gait_pose(legs, p, 2 * pi * (i + 1) / steps, 1, velocity);
    for (std::size_t side = 0; side < 2; ++side) {
      for (std::size_t k = 0; k < legs[side].joints.size(); ++k)
        fastest = std::max(fastest, std::abs(b.q[side][k] - a.q[side][k]) * steps / p.period);
    }
  }
  return fastest;
}

TEST(WalkEngine, AsksNoJointForMoreThanItsLargestRate) {
  const std::array<Leg, 2> legs = find_legs(*test::kid21());
  const WalkParameters free = seeded_parameters(legs);
  ASSERT_GT(fastest_hinge(legs, free, {free.fastest.x, 0, 0}), 6) << "a limit of 4 rad/s says something";
  for (const double most : {6.0, 4.0}) {
    const WalkParameters p = seeded_parameters(with_rates(most));
    for (const Vec3d& velocity : {Vec3d{}, Vec3d{p.fastest.x, 0, 0.5 * p.fastest.z}, Vec3d{-p.fastest.x, 0, 0},
                                  Vec3d{0, p.fastest.y, 0}, Vec3d{0, 0, p.fastest.z}})
      EXPECT_LT(fastest_hinge(legs, p, velocity), most);
    EXPECT_LT(p.lift, free.lift);
    EXPECT_GT(p.lift, 0.3 * free.lift) << "feet still leave the ground";
    EXPECT_GT(p.fastest.x, 0.3 * free.fastest.x);
  }
  const WalkParameters same = seeded_parameters(with_rates(20));
  EXPECT_EQ(same.lift, free.lift);
  EXPECT_EQ(same.fastest.x, free.fastest.x);
}

TEST(WalkEngine, StopsWhenTheCommandBecomesZero) {
  Walker walker({0.2, 0, 0});
  walker.rig.run(3.0);
  walker.robot.base().set(properties::walk_command, {});
  walker.rig.run(2.0);
  EXPECT_EQ(walker.robot.base().get(properties::gait_amplitude), 0);
  const Vec3d place = test::Rig::place(walker.robot);
  walker.rig.run(1.0);
  law::expect_below({.law = "walk command becomes zero: way in the third second after",
                     .level = "walk_engine, kinematic_walking",
                     .source = "it stands"},
                    norm(test::Rig::place(walker.robot) - place), 1e-6, "m");
}

/// A chaser alone with a ball on kinematic feet; returns how far the ball came towards the goal at positive x.
double chase(const Vec3d& start, double heading, const Vec3d& ball_place) {
  test::Rig rig;
  Entity& robot = rig.add("robot", test::kid21(), {.position = start, .heading = heading, .team = "blue"});
  Entity& ball = rig.add("ball", scene_file::ball_model(), {.position = ball_place});
  const std::vector<Entity*> entities{&robot, &ball};
  rig.simulation.attach<sensors::GroundTruth>("ground_truth", robot, 20, sensors::SensorSpec{.name = "ground_truth"},
                                              sensors::SensorSurroundings{.moving_entities = entities});
  rig.simulation.attach<soccer::BallChaser>("ball_chaser", robot, 20, soccer::BallChaserOptions{.goal = {3, 0, 0}});
  rig.simulation.attach<WalkEngine>("walk_engine", robot, 100);
  rig.materials.set("ball", "", {.friction = 0.5, .rolling = 0.03, .restitution = 0.5});
  rig.attach_together({{&robot, {.level = "kinematic_walking"}}, {&ball, {}}});
  rig.run(30);
  return test::Rig::place(ball).x - ball_place.x;
}

// From behind, from the side, from in front of the ball, and turned away: the ball must go towards the goal.
TEST(BallChaser, BringsTheBallTowardsTheGoal) {
  EXPECT_GT(chase({-1, 0, 0}, 0, {0, 0, 0}), 1.0);
  EXPECT_GT(chase({-1, 0.5, 0}, 2.5, {0, 0, 0}), 0.8);
  EXPECT_GT(chase({0, -1, 0}, 1.5, {0, 0, 0}), 0.8);
  EXPECT_GT(chase({1, 0.1, 0}, 3.1, {0, 0, 0}), 0.5);
}

}  // namespace
}  // namespace murosimf::locomotion
