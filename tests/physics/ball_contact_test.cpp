// Ball against robots: what one gains the other loses, or its ledger shows.
#include <gtest/gtest.h>

#include "murosimf/collision/ball_contact.h"
#include "tests/law.h"
#include "tests/physics/rig.h"

namespace murosimf::test {
namespace {

/// A ball of 0.1 kg flies with 1 m/s along -x at the shin of a robot, without gravity.
struct Kick {
  explicit Kick(bool kinematic) {
    rig.simulation.world().gravity = {};
    robot = &rig.add("robot", kid21(), {.position = {0, 0, kinematic ? 0.0 : 1.0}});
    ball = &rig.add("ball", io::ball_model(), {.position = {0.25, 0.05, kinematic ? 0.05 : 1.05}});
    rig.simulation.attach<collision::BallContact>("ball_contact", *rig.ground, 1000, *ball, std::vector<Entity*>{robot},
                                                  MaterialTable::standard());
    rig.attach_dynamics(*ball, {.on_ground = false});
    if (kinematic) {
      rig.simulation.attach<control::WalkEngine>("walk_engine", *robot, 100, Vec3d{0.2, 0, 0});
      rig.simulation.attach<motion::KinematicWalking>("kinematic_walking", *robot, 1000);
    } else {
      rig.attach_dynamics(*robot, {.on_ground = false});
    }
    rig.simulation.initialize();
    Rig::launch(*ball, {-1, 0, 0}, {0, 3, 2});
  }

  static Vec3d momentum(Entity& e) { return e.base().get(properties::total_mass) * Rig::velocity(e); }
  /// About the world's origin.
  static Vec3d angular_momentum(Entity& e) {
    return cross(e.base().get(properties::common_center_of_mass), momentum(e)) +
           e.base().get(properties::common_inertia) * e.base().get(properties::angular_velocity);
  }

  Rig rig;
  Entity* robot = nullptr;
  Entity* ball = nullptr;
};

TEST(BallContact, KeepsTheMomentumOfADynamicPair) {
  Kick kick(false);
  kick.rig.simulation.step();  // takes over the ball's launch
  const Vec3d P = Kick::momentum(*kick.ball) + Kick::momentum(*kick.robot);
  kick.rig.run(0.5);
  EXPECT_GT(Rig::velocity(*kick.ball).x, 0.1) << "the ball did not bounce";
  law::expect_below({.law = "ball hits robot: change of the pair's momentum",
                     .level = "simplified_dynamics",
                     .source = "forces are equal and opposite: none"},
                    norm(Kick::momentum(*kick.ball) + Kick::momentum(*kick.robot) - P), 1e-12, "N s");
}

// A kinematic robot feels nothing; ball and ledger together keep momentum to rounding, and angular momentum up to the
// ball's way within a step times its force (1 mm of 0.1 N s: 1e-4 N m s).
TEST(BallContact, LedgerClosesTheBalanceOfAKinematicRobot) {
  Kick kick(true);
  kick.rig.simulation.step();  // takes over the ball's launch
  const Vec3d P = Kick::momentum(*kick.ball);
  const Vec3d L = Kick::angular_momentum(*kick.ball);
  kick.rig.run(0.5);
  const Forced ledger = kick.robot->base().get(properties::absorbed_impulse);
  EXPECT_GT(Rig::velocity(*kick.ball).x, 0.1) << "the ball did not bounce";
  EXPECT_GT(norm(ledger.f), 0.1);
  law::expect_below({.law = "ball hits robot: change of the momentum of ball and ledger",
                     .level = "kinematic_walking",
                     .source = "the ledger takes what the ball loses: none"},
                    norm(Kick::momentum(*kick.ball) + ledger.f - P), 1e-10, "N s");
  law::expect_below({.law = "ball hits robot: change of the angular momentum of ball and ledger",
                     .level = "kinematic_walking",
                     .source = "none, up to the ball's way in one step times its impulse"},
                    norm(Kick::angular_momentum(*kick.ball) + ledger.n - L), 1e-4, "N m s");
}

// A kinematic robot that walks into a resting ball pushes it forward, and is not slowed down itself.
TEST(BallContact, KinematicRobotPushesTheBall) {
  Rig rig;
  Entity& robot = rig.add("robot", kid21());
  Entity& ball = rig.add("ball", io::ball_model(), {.position = {0.4, 0.05, 0}});
  rig.simulation.attach<collision::BallContact>("ball_contact", *rig.ground, 1000, ball, std::vector<Entity*>{&robot},
                                                MaterialTable::standard());
  rig.attach_dynamics(ball);
  rig.simulation.attach<control::WalkEngine>("walk_engine", robot, 100, Vec3d{0.2, 0, 0});
  rig.simulation.attach<motion::KinematicWalking>("kinematic_walking", robot, 1000);
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
