// Limbs of one robot touch each other where that is switched on.
#include <gtest/gtest.h>

#include "murosimf/collision/touches.h"
#include "tests/fixtures.h"
#include "tests/law.h"
#include "tests/physics/encounters.h"

namespace murosimf::test {
namespace {

constexpr const char* level = "articulated_dynamics";
constexpr double gain = 5;        // [N m/rad]
constexpr double shoulder = 0.2;  // [m] beside the middle of the torso
constexpr double forearm = 0.2;   // [m] from the elbow to the middle of its round end
constexpr double radius = 0.02;   // [m] of the round end
constexpr double side = 0.1;      // [m] of the torso's surface from its middle

Servo servo() {
  Servo servo;
  servo.law = "ideal_pd";
  servo.position_gain = gain;
  servo.velocity_gain = 0.1;
  servo.rotor_inertia = 1e-3;
  return servo;
}

Chain limb(Chain chain, const std::string& joint, double length) {
  PlacedShape shape;
  shape.shape = Capsule{radius, length / 2};
  shape.position = {0, 0, -length / 2};
  return chain.revolute(joint, {1, 0, 0})
      .with(properties::mass, 0.2)
      .with(properties::center_of_mass, {0, 0, -length / 2})
      .with(properties::inertia, diagonal(1e-3))
      .with(properties::servo, servo())
      .with(properties::shapes, {shape});
}

/// A torso with an arm of two links that hangs down beside it.
ModelPtr torso_with_arm() {
  PlacedShape torso;
  torso.shape = Box{{side, side, 0.3}};
  Chain chain;
  chain.base("torso")
      .with(properties::mass, 3)
      .with(properties::inertia, diagonal(0.05))
      .with(properties::shapes, {torso});
  chain.translation({0, shoulder, 0.1});
  chain = limb(chain, "upper", 0.15);
  chain.translation({0, 0, -0.15});
  return std::make_shared<const Model>("torso_with_arm", limb(chain, "elbow", forearm));
}

/// The elbow is told to bend into the torso, without gravity.
struct Bender {
  explicit Bender(const CollisionOptions& collision, bool bolted = true, double target = -1.2) {
    rig.simulation.world().gravity = {};
    robot = &rig.add("robot", torso_with_arm(), {.collision = collision});
    rig.attach_together({{robot, {.level = level, .on_ground = false, .tree = {.fixed_base = bolted}}}});
    rig.simulation.initialize();
    robot->object("elbow").set(properties::joint_target, target);
  }
  double elbow() { return robot->object("elbow").get(properties::joint_position); }
  double upper() { return robot->object("upper").get(properties::joint_position); }
  std::vector<collision::Touch> touches() { return collision::touches(rig.simulation.world(), *robot); }
  /// How deep the round end of the forearm is in the torso, by trigonometry.
  double depth() {
    const double a = upper(), b = a + elbow();
    return radius - (shoulder + 0.15 * std::sin(a) + forearm * std::sin(b) - side);
  }
  Rig rig;
  Entity* robot = nullptr;
};

TEST(SelfCollision, StopsAnArmAtTheTorso) {
  Bender bender({.self_collision = true});
  law::Worst deepest;
  for (int i = 0; i < 3000; ++i) {
    bender.rig.simulation.step();
    deepest.see(bender.depth(), "step", i);
  }
  law::expect_below({.law = "arm is driven into the torso: deepest overlap",
                     .level = level,
                     .source = "a quarter of the arm's radius"},
                    deepest, 0.25 * radius, "m");
  const auto found = bender.touches();
  ASSERT_EQ(found.size(), 2u) << "one point, seen from both limbs";
  EXPECT_EQ(found[0].entity, found[0].other);
  EXPECT_EQ(found[0].object, found[1].other_object);
  EXPECT_EQ(norm(found[0].force + found[1].force), 0);
  EXPECT_NEAR(found[0].depth, bender.depth(), 1e-6);
  // at rest the torque of either servo is the moment of the contact force about its joint
  const auto& of_arm = found[0].object > found[1].object ? found[0] : found[1];
  law::Worst off;
  for (const std::string joint : {"upper", "elbow"}) {
    auto object = bender.robot->object(joint);
    const Vec3d arm = of_arm.point - object.get(properties::position);
    const double torque = object.get(properties::joint_torque);
    EXPECT_GT(std::abs(torque), 0.1);
    off.see(std::abs(torque + cross(arm, of_arm.force).x), joint);
  }
  law::expect_below({.law = "arm leans on the torso: servo torque minus moment of the contact force",
                     .level = level,
                     .source = "equilibrium of every link"},
                    off, 1e-4, "N m");
}

TEST(SelfCollision, IsOffByDefaultAndForExcludedPairs) {
  for (const CollisionOptions& options :
       {CollisionOptions{}, CollisionOptions{.self_collision = true, .never = {{"torso", "elbow"}}}}) {
    Bender bender(options);
    bender.rig.run(3);
    EXPECT_NEAR(bender.elbow(), -1.2, 1e-3);
    EXPECT_GT(bender.depth(), radius);
    EXPECT_TRUE(bender.touches().empty());
  }
}

// In free flight forces between limbs of one robot change nothing for the whole.
TEST(SelfCollision, KeepsTheMomentumOfTheRobot) {
  double drift[2];
  for (const bool on : {false, true}) {
    Bender bender({.self_collision = on}, false);
    Rig::launch(*bender.robot, {0.3, -0.2, 0.1});
    bender.rig.simulation.step();
    const Vec3d before = linear_momentum(*bender.robot);
    bender.rig.run(2);
    drift[on] = norm(linear_momentum(*bender.robot) - before);
    EXPECT_EQ(bender.touches().empty(), !on);
  }
  law::expect_below({.law = "limbs touch in free flight: change of the robot's momentum beyond that without contact",
                     .level = level,
                     .source = "inner forces: none"},
                    drift[1] - drift[0], 1e-12, "N s");
}

TEST(SelfCollision, RestsWithoutDrift) {
  Bender bender({.self_collision = true}, false);
  bender.rig.run(5);
  const Vec3d place = Rig::place(*bender.robot);
  const double angle = bender.elbow();
  bender.rig.run(2);
  EXPECT_FALSE(bender.touches().empty());
  law::expect_below({.law = "limbs lean on each other in free flight: way of the base in 2 s",
                     .level = level,
                     .source = "nothing moves it: none"},
                    norm(Rig::place(*bender.robot) - place), 1e-6, "m");
  EXPECT_NEAR(bender.elbow(), angle, 1e-6);
}

// Errors in an entity's options name it, and what could have been meant.
TEST(CollisionOptions, MistakesAreNamed) {
  const auto error = [](const CollisionOptions& options) {
    return fixtures::error_of([&] { Bender bender(options); });
  };
  EXPECT_TRUE(fixtures::says(error({.volume = "capsul"}), {"robot", "'capsul'", "'capsule'"}));
  EXPECT_TRUE(
      fixtures::says(error({.self_collision = true, .never = {{"torso", "elbov"}}}), {"robot", "'elbov'", "'elbow'"}));
}

}  // namespace
}  // namespace murosimf::test
