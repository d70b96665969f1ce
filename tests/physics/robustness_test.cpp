// Numbers that go bad freeze one entity; the others play on.
#include <gtest/gtest.h>

#include <limits>

#include "murosimf/collision/contact_properties.h"
#include "murosimf/dynamics/simplified_dynamics.h"
#include "tests/law.h"
#include "tests/physics/rig.h"

namespace murosimf::test {
namespace {

/// Writes NaN into a joint target after half a second.
class Saboteur final : public Algorithm {
 public:
  explicit Saboteur(Setup& setup) : target_(setup.write(properties::joint_target)) {}
  [[nodiscard]] Phase phase() const noexcept override { return Phase::control; }
  void initialize() override { std::fill(target_.begin(), target_.end(), 0.0); }
  void step(const Instant& instant) noexcept override {
    if (instant.now >= from_seconds(0.5)) target_[3] = std::numeric_limits<double>::quiet_NaN();
  }

 private:
  std::span<double> target_;
};

TEST(Freezing, BadTargetsFreezeOneRobotOnly) {
  Rig rig;
  Entity& bad = rig.add("bad", kid21());
  Entity& good = rig.add("good", kid21(), {.position = {1, 0, 0}});
  const int joint = kid21()->joints()[0];
  ASSERT_EQ(joint, 3) << "the saboteur's target must be a joint's";
  rig.simulation.attach<Saboteur>("saboteur", bad, 100);
  rig.simulation.attach<locomotion::WalkEngine>("walk_engine", good, 100, Vec3d{0.2, 0, 0});
  rig.attach_dynamics(bad);
  rig.attach_dynamics(good);
  rig.run(3.0);
  EXPECT_TRUE(bad.frozen());
  EXPECT_TRUE(std::isfinite(norm(Rig::place(bad))));
  EXPECT_FALSE(good.frozen());
  EXPECT_GT(Rig::place(good).x, 1.3);
  ASSERT_EQ(rig.simulation.warnings().size(), 1u);
  EXPECT_NE(rig.simulation.warnings()[0].find("'bad' was frozen at 0.50"), std::string::npos)
      << rig.simulation.warnings()[0];
}

/// Sets one joint target far beyond anything sensible, but finite.
TEST(Freezing, AbsurdTargetsFreezeAtEveryLevel) {
  for (const std::string& level : all_levels()) {
    Rig rig;
    Entity& robot = rig.add("robot", kid21());
    rig.attach_motion(robot, {.level = level});
    rig.run(0.1);
    const Vec3d place = Rig::place(robot);
    robot.object("j_l_shin").set(properties::joint_target, 1e300);
    rig.run(0.1);
    EXPECT_TRUE(robot.frozen());
    law::expect_below({.law = "absurd joint target freezes the robot: jump of its base",
                       .level = level,
                       .source = "it stays where it was"},
                      norm(Rig::place(robot) - place), 1e-3, "m");
  }
}

// A frozen ball is out of the game: it must not push robots with its last force for ever.
TEST(Freezing, AFrozenBallPushesNobody) {
  Rig rig;
  rig.simulation.world().gravity = {};
  Entity& robot = rig.add("robot", kid21(), {.position = {0, 0, 1}});
  Entity& ball = rig.add("ball", scene_file::ball_model(), {.position = {0.12, 0.05, 1.05}});
  rig.attach_together({{&robot, {.on_ground = false}}, {&ball, {.on_ground = false}}});
  rig.simulation.initialize();
  Rig::launch(ball, {-1, 0, 0});
  for (int i = 0; i < 200 && norm(Rig::velocity(robot)) == 0; ++i) rig.simulation.step();
  ASSERT_GT(norm(Rig::velocity(robot)), 0) << "the ball did not touch the robot";
  ball.freeze("a test wants it");
  rig.run(0.002);
  const Vec3d v = Rig::velocity(robot);
  rig.run(0.1);
  law::expect_below({.law = "frozen ball touches a robot: the robot's change of speed in 0.1 s",
                     .level = "simplified_dynamics",
                     .source = "frozen is out of the game: none"},
                    norm(Rig::velocity(robot) - v), 1e-12, "m/s");
}

// Users may throw a ball and carry a robot by name while the simulation runs.
TEST(Access, TheBaseCanBeMovedByName) {
  Rig rig;
  Entity& ball = rig.add("ball", scene_file::ball_model());
  Entity& walker = rig.add("walker", kid21(), {.position = {1, 0, 0}});
  rig.attach_dynamics(ball);
  rig.simulation.attach<dynamics::KinematicWalking>("kinematic_walking", walker, 1000);
  rig.run(0.5);
  const std::vector<double> place{-2, 1, 0.5}, speed{0, 0, 3};
  ball.object("ball").set("position", place);
  ball.object("ball").set("linear_velocity", speed);
  const Vec3d before = Rig::place(walker);
  walker.base().set(properties::position, before + Vec3d{0, 0.5, 0});
  rig.run(0.001);
  EXPECT_NEAR(Rig::place(ball).x, -2, 1e-9);
  EXPECT_NEAR(Rig::velocity(ball).z, 3 - g * 0.001, 1e-9);
  EXPECT_NEAR(Rig::place(walker).y, before.y + 0.5, 1e-9);
}

// A body needs no contact algorithm to fall, and one without inertia is refused before it falls.
TEST(Setup, MotionWithoutContact) {
  Rig rig;
  Entity& ball = rig.add("ball", scene_file::ball_model(), {.position = {0, 0, 1}});
  rig.simulation.attach<dynamics::SimplifiedDynamics>("simplified_dynamics", ball, 1000);
  rig.run(0.1);
  EXPECT_FALSE(ball.frozen());
  law::expect_near({.law = "free fall: speed after t = 0.1 s",
                    .level = "simplified_dynamics, without contact algorithm",
                    .source = "-g t"},
                   Rig::velocity(ball).z, -0.1 * g, 1e-9, "m/s");

  Rig other;
  auto point = std::make_shared<const Model>("point", Chain{}.base("base").with(properties::mass, 1.0));
  other.attach_dynamics(other.add("point", point));
  EXPECT_THROW(other.run(0.1), SetupError);
}

// An algorithm whose constructor refuses leaves nothing behind.
TEST(Setup, AFailedAttachLeavesNothingBehind) {
  Rig rig;
  Entity& ball = rig.add("ball", scene_file::ball_model());
  EXPECT_THROW(rig.simulation.attach<dynamics::KinematicWalking>("kinematic_walking", ball, 1000), SetupError);
  rig.attach_dynamics(ball);
  rig.run(0.1);
  EXPECT_FALSE(ball.frozen());
}

TEST(Freezing, BadForcesFreezeTheEntityThatFeelsThem) {
  Rig rig;
  Entity& ball = rig.add("ball", scene_file::ball_model());
  rig.attach_dynamics(ball);
  rig.run(0.1);
  const double infinite = std::numeric_limits<double>::infinity();
  ball.base().set(properties::applied_force, Wrenchd{{}, {infinite, 0, 0}});
  rig.run(0.1);
  EXPECT_TRUE(ball.frozen());
  EXPECT_TRUE(std::isfinite(norm(Rig::place(ball))));
}

}  // namespace
}  // namespace murosimf::test
