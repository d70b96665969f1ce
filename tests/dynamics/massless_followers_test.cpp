// Joints that follow another one and move no inertia: they count as a part of their leader.
#include <gtest/gtest.h>

#include "murosimf/dynamics/motion_properties.h"
#include "tests/fixtures.h"
#include "tests/physics/bolted.h"

namespace murosimf::dynamics {
namespace {

using test::Bolted;

constexpr double J = 0.02;                  // [kg m^2] of the leader about its vertical hinge
constexpr double first = -1.5, then = 0.4;  // [1] ratios of a chain of followers

Chain follower(const std::string& name, const JointCoupling& coupling, double damping = 0) {
  return Chain{}
      .revolute(name, {0, 0, 1})
      .with(properties::joint_coupling, coupling)
      .with(properties::joint_damping, damping);
}

/// A leader, and a finger of two followers without mass, of which the second follows the first and hangs on it.
Chain hand(double damping, bool leader_has_mass = true) {
  Chain leader = Chain{}.revolute("leader", {0, 0, 1});
  if (leader_has_mass) leader.with(properties::mass, 1.0).with(properties::inertia, diagonal(J));
  Chain finger = follower("first", {"leader", first, 0.3}, damping).translation({0.1, 0, 0});
  finger.revolute("second", {0, 0, 1}).with(properties::joint_coupling, {"first", then, -0.1});
  return Chain{}.base("palm").with(properties::mass, 2.0).with(properties::inertia, diagonal(0.1)).fork(leader, finger);
}

struct Gaps {
  double first, second;  // [rad]
};
Gaps gaps(Bolted& robot) {
  const auto q = [&](const char* name) { return robot.joint(name).get(properties::joint_position); };
  return {q("first") - 0.3 - first * q("leader"), q("second") + 0.1 - then * q("first")};
}

// Closed form: the follower's damper brakes the leader with r^2 b, so its rate falls by 1 / (1 + h r^2 b / J) in a step.
TEST(MasslessFollowers, BrakeTheirLeaderWithTheirDamper) {
  constexpr double damping = 0.03;  // [N m s/rad]
  Bolted robot(hand(damping));
  robot.joint("leader").set(properties::joint_velocity, 2);
  robot.joint("first").set(properties::joint_velocity, 2 * first);
  robot.joint("second").set(properties::joint_velocity, 2 * first * then);
  double rate = 2, way = 0;
  for (int i = 0; i < 500; ++i) {
    robot.rig.simulation.step();
    rate /= 1 + 1e-3 * first * first * damping / J;
    way += 1e-3 * rate;
  }
  EXPECT_LT(rate, 0.4);
  EXPECT_NEAR(robot.joint("leader").get(properties::joint_velocity), rate, 2e-3);
  EXPECT_NEAR(robot.joint("leader").get(properties::joint_position), way, 2e-3);
  EXPECT_NEAR(gaps(robot).first, 0, 1e-4);
  EXPECT_NEAR(gaps(robot).second, 0, 1e-4);
}

// Without a damper they weigh nothing: the leader keeps its rate, and they the ratio.
TEST(MasslessFollowers, WeighNothing) {
  Bolted robot(hand(0));
  robot.joint("leader").set(properties::joint_velocity, 2);
  robot.joint("first").set(properties::joint_velocity, 2 * first);
  robot.joint("second").set(properties::joint_velocity, 2 * first * then);
  robot.rig.run(0.5);
  EXPECT_NEAR(robot.joint("leader").get(properties::joint_velocity), 2, 1e-9);
  EXPECT_NEAR(gaps(robot).first, 0, 1e-9);
  EXPECT_NEAR(gaps(robot).second, 0, 1e-9);
}

TEST(MasslessFollowers, OfALeaderThatMovesNothingEitherAreRefused) {
  EXPECT_TRUE(fixtures::says(fixtures::error_of([] { Bolted(hand(0, false)); }), {"moves no inertia"}));
}

}  // namespace
}  // namespace murosimf::dynamics
