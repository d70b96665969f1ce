// Bodies that move against each other: what one gains the other loses, or its ledger shows.
#include <gtest/gtest.h>

#include "murosimf/collision/contact_properties.h"
#include "murosimf/dynamics/motion_properties.h"
#include "tests/law.h"
#include "tests/physics/rig.h"

namespace murosimf::test {
namespace {

Vec3d momentum(Entity& e) { return e.base().get(properties::total_mass) * Rig::velocity(e); }

/// A ball of 0.1 kg flies with 1 m/s along -x at the shin of a robot, without gravity.
struct Kick {
  explicit Kick(const std::string& level, const std::string& law = "island_gauss_seidel") {
    const bool kinematic = level == "kinematic_walking";
    rig.simulation.world().gravity = {};
    robot = &rig.add("robot", kid21(), {.position = {0, 0, kinematic ? 0.0 : 1.0}});
    ball = &rig.add("ball", scene_file::ball_model(), {.position = {0.25, 0.05, kinematic ? 0.05 : 1.05}});
    rig.simulation.attach<locomotion::WalkEngine>("walk_engine", *robot, 100, Vec3d{kinematic ? 0.2 : 0, 0, 0});
    rig.materials = MaterialTable::standard();
    rig.attach_together({{robot, {.level = level, .on_ground = false}}, {ball, {.on_ground = false}}}, law);
    rig.simulation.initialize();
    Rig::launch(*ball, {-1, 0, 0}, {0, 3, 2});
  }

  /// About the world's origin, of an entity of one body.
  static Vec3d angular_momentum(Entity& e) {
    return cross(e.base().get(properties::common_center_of_mass), momentum(e)) +
           e.base().get(properties::common_inertia) * e.base().get(properties::angular_velocity);
  }

  Rig rig;
  Entity* robot = nullptr;
  Entity* ball = nullptr;
};

/// A level and a law between bodies.
using LevelAndPairLaw = std::tuple<std::string, std::string>;

class PairOfLevels : public testing::TestWithParam<LevelAndPairLaw> {};

// Momentum after the ball has left, to rounding: without ground, trees correct what semi-implicit integration loses. With
// `carry` the balance is closed when contact is over, up to what a body turns in a step.
TEST_P(PairOfLevels, KeepsTheMomentumOfBallAndRobot) {
  const auto& [level, law] = GetParam();
  Kick kick(level, law);
  kick.rig.simulation.step();  // takes over the ball's launch
  const Vec3d P = momentum(*kick.ball) + momentum(*kick.robot);
  kick.rig.run(0.5);
  EXPECT_GT(Rig::velocity(*kick.ball).x, 0.02) << "the ball did not bounce";
  const bool exact = law != "carry";
  law::expect_below({.law = "ball hits robot: change of the pair's momentum",
                     .level = level + ", " + law,
                     .source = "forces are equal and opposite: none"},
                    norm(momentum(*kick.ball) + momentum(*kick.robot) - P), exact ? 1e-12 : 1e-4, "N s");
}

INSTANTIATE_TEST_SUITE_P(Bodies, PairOfLevels,
                         testing::Combine(testing::ValuesIn(dynamic_levels()), testing::ValuesIn(body_laws())),
                         [](const auto& test) { return std::get<0>(test.param) + "_" + std::get<1>(test.param); });

/// Two equal balls, the second one flies at the first off its middle, without gravity.
struct Billiards {
  explicit Billiards(const std::string& law) {
    rig.simulation.world().gravity = {};
    rig.materials = MaterialTable::standard();
    a = &rig.add("a", scene_file::ball_model());
    b = &rig.add("b", scene_file::ball_model(), {.position = {0.3, 0.03, 0.02}});
    rig.attach_together({{a, {.on_ground = false}}, {b, {.on_ground = false}}}, law);
    rig.simulation.initialize();
    Rig::launch(*b, {-2, 0, 0}, {5, 0, 10});
    rig.simulation.step();
  }
  Rig rig;
  Entity* a = nullptr;
  Entity* b = nullptr;
};

class BodyContactLaws : public testing::TestWithParam<std::string> {};

TEST_P(BodyContactLaws, TwoSpheresKeepMomentumAndMomentOfMomentum) {
  Billiards table(GetParam());
  const Vec3d P = momentum(*table.a) + momentum(*table.b);
  const auto L = [&] { return Kick::angular_momentum(*table.a) + Kick::angular_momentum(*table.b); };
  const Vec3d L_before = L();
  table.rig.run(0.5);
  EXPECT_LT(Rig::velocity(*table.a).x, -0.5) << "the balls did not meet";
  const bool late = GetParam() == "carry";
  law::expect_below({.law = "two spheres collide off their middle: change of momentum",
                     .level = "simplified_dynamics, " + GetParam(),
                     .source = late ? "none once contact is over, up to its last step" : "none, up to rounding"},
                    norm(momentum(*table.a) + momentum(*table.b) - P), late ? 1e-3 : 1e-13, "N s");
  // forces act at one common point, but during the step both bodies move on: h v x f, 1 ms of 0.2 N s at 2 m/s
  law::expect_below({.law = "two spheres collide off their middle: change of the moment of momentum",
                     .level = "simplified_dynamics, " + GetParam(),
                     .source = "none, up to the way in one step times the impulse"},
                    norm(L() - L_before), 4e-4, "N m s");
}

INSTANTIATE_TEST_SUITE_P(Bodies, BodyContactLaws, testing::ValuesIn(body_laws()), level_name);

class Ledger : public testing::TestWithParam<std::string> {};

// A kinematic robot feels nothing; ball and ledger together keep momentum to rounding, and angular momentum up to the
// ball's way within a step times its force (1 mm of 0.1 N s: 1e-4 N m s).
TEST_P(Ledger, ClosesTheBalanceOfAKinematicRobot) {
  Kick kick("kinematic_walking", GetParam());
  kick.rig.simulation.step();  // takes over the ball's launch
  const Vec3d P = momentum(*kick.ball);
  const Vec3d L = Kick::angular_momentum(*kick.ball);
  kick.rig.run(0.5);
  const Wrenchd ledger = kick.robot->base().get(properties::absorbed_impulse);
  EXPECT_GT(Rig::velocity(*kick.ball).x, 0.1) << "the ball did not bounce";
  EXPECT_GT(norm(ledger.f), 0.1);
  const std::string level = "kinematic_walking, " + GetParam();
  law::expect_below({.law = "ball hits robot: change of the momentum of ball and ledger",
                     .level = level,
                     .source = "the ledger takes what the ball loses: none"},
                    norm(momentum(*kick.ball) + ledger.f - P), 1e-10, "N s");
  law::expect_below({.law = "ball hits robot: change of the angular momentum of ball and ledger",
                     .level = level,
                     .source = "none, up to the ball's way in one step times its impulse"},
                    norm(Kick::angular_momentum(*kick.ball) + ledger.n - L), 1e-4, "N m s");
}

INSTANTIATE_TEST_SUITE_P(Bodies, Ledger, testing::ValuesIn(body_laws()), level_name);

// A kinematic robot that walks into a resting ball pushes it forward, and is not slowed down itself.
TEST(BodyContact, KinematicRobotPushesTheBall) {
  Rig rig;
  Entity& robot = rig.add("robot", kid21());
  Entity& ball = rig.add("ball", scene_file::ball_model(), {.position = {0.4, 0.05, 0}});
  rig.simulation.attach<locomotion::WalkEngine>("walk_engine", robot, 100, Vec3d{0.2, 0, 0});
  rig.materials = MaterialTable::standard();
  rig.attach_together({{&robot, {.level = "kinematic_walking"}}, {&ball, {}}});
  rig.run(5.0);
  law::expect_above({.law = "robot walks into a resting ball: place of the ball after 5 s, from 0.4 m",
                     .level = "kinematic_walking",
                     .source = "the ball is pushed on"},
                    Rig::place(ball).x, 0.6, "m");
  law::expect_above({.law = "robot walks into a resting ball: way of the robot in 5 s",
                     .level = "kinematic_walking",
                     .source = "it is not slowed down"},
                    Rig::place(robot).x, 0.8, "m");
  EXPECT_LT(norm(Rig::velocity(ball)), 3.0);
}

}  // namespace
}  // namespace murosimf::test
