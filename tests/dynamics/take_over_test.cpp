// What levels say right after they have taken over a moving robot: velocities are those of the places that follow.
#include <gtest/gtest.h>

#include "murosimf/collision/contact_properties.h"
#include "murosimf/dynamics/kinematic_walking.h"
#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/dynamics/simplified_dynamics.h"
#include "tests/fixtures.h"
#include "tests/physics/mechanics.h"
#include "tests/physics/rig.h"

namespace murosimf::dynamics {
namespace {

using fixtures::difference;
using test::degree;
using test::Rig;

struct Base {
  Vec3d r, v, w;
  Mat3d R;
};

Base base_of(Entity& robot) {
  const auto base = robot.base();
  return {base.get(properties::position), base.get(properties::linear_velocity), base.get(properties::angular_velocity),
          base.get(properties::orientation)};
}

/// A robot that leans by 6 degrees about (0.6, 0.8, 0), 12 mm above the ground, and is taken over as it stands there.
struct Pinned {
  Pinned() {
    rig.simulation.world().gravity = {};
    robot = &rig.add("robot", std::make_shared<const Model>(fixtures::two_legged()),
                     {.position = {0.5, -0.3, 0.012},
                      .heading = 0.4,
                      .attitude = to_matrix(exponential(6 * degree * Vec3d{0.6, 0.8, 0}))});
    rig.attach_dynamics(*robot, {.level = "simplified_dynamics", .on_ground = false});
    rig.simulation.step();
    before = base_of(*robot);
    rig.exchange(*robot, "kinematic_walking");
  }
  Rig rig;
  Entity* robot = nullptr;
  Base before;
};

// s' = -s / 0.1 s, implicit: what the columns say is exactly the way of the step to them. The sole does not turn about the
// base, so on the way of the base differ arc and tangent, w^2 |r_S| dt / 2 = 2e-4.
TEST(KinematicTakeOver, VelocityIsThatOfTheFadingRemainder) {
  Pinned pinned;
  Base last = base_of(*pinned.robot);
  EXPECT_LT(difference(last.r, pinned.before.r), 1e-12);
  EXPECT_LT(difference(last.R, pinned.before.R), 1e-12);
  EXPECT_EQ(pinned.robot->base().get(properties::dynamic), 0);
  EXPECT_LT(norm(last.v), 1e-9) << "it was at rest";
  EXPECT_LT(norm(last.w), 1e-9) << "it was at rest";
  double fastest = 0, fastest_turn = 0;
  for (int i = 0; i < 300; ++i) {
    pinned.rig.simulation.step();
    const Base now = base_of(*pinned.robot);
    fastest = std::max(fastest, norm(now.v));
    fastest_turn = std::max(fastest_turn, norm(now.w));
    EXPECT_LT(difference(now.v, 1e3 * (now.r - last.r)), 4e-4) << i;
    EXPECT_LT(difference(now.w, 1e3 * rotation_vector(from_matrix(now.R * transpose(last.R)))), 1e-6) << i;
    last = now;
  }
  EXPECT_GT(fastest, 0.05) << "12 mm in 0.1 s";
  EXPECT_GT(fastest_turn, 0.3) << "6 degrees in 0.1 s";
}

// Rule: an exchange leaves the velocities as they are, and with them the momentum that the next level finds.
TEST(KinematicTakeOver, BaseAndJointsGoOnAsTheyWere) {
  Rig rig;
  rig.simulation.world().gravity = {};
  Entity& robot = rig.add("robot", std::make_shared<const Model>(fixtures::two_legged()), {.position = {0, 0, 0.002}});
  rig.attach_dynamics(robot, {.level = "articulated_dynamics", .on_ground = false});
  rig.simulation.initialize();
  Rig::launch(robot, {0.1, -0.05, 0.02}, {0.3, -0.2, 0.1});
  robot.object("left_knee").set(properties::joint_velocity, 0.5);
  rig.simulation.step();
  const Base before = base_of(robot);
  const double rate = robot.object("left_knee").get(properties::joint_velocity);
  const Wrenchd momentum = test::momentum(robot);
  rig.exchange(robot, "kinematic_walking");
  EXPECT_LT(difference(base_of(robot).v, before.v), 1e-12);
  EXPECT_LT(difference(base_of(robot).w, before.w), 1e-12);
  EXPECT_EQ(robot.object("left_knee").get(properties::joint_velocity), rate);
  rig.exchange(robot, "full_dynamics");
  EXPECT_LT(difference(test::momentum(robot).f, momentum.f), 1e-9);
  EXPECT_LT(difference(test::momentum(robot).n, momentum.n), 1e-9);
}

TEST(KinematicTakeOver, RemainderIsGoneAfterAWhile) {
  Pinned pinned;
  const Base start = base_of(*pinned.robot);
  const Vec3d shift = pinned.robot->base().get(properties::remaining_shift);
  const Vec3d turn = pinned.robot->base().get(properties::remaining_turn);
  const auto soles = pinned.robot->model().having(properties::sole);
  const int sole = soles[static_cast<std::size_t>(pinned.robot->base().get(properties::stance_foot))];
  const Vec3d stood = pinned.robot->column(properties::position).values[sole];
  pinned.rig.run(0.1);
  const Base later = base_of(*pinned.robot);
  pinned.rig.run(3);
  const Base end = base_of(*pinned.robot);
  // of s'' with both times, from rest: (0.1 exp(-t / 0.1 s) - 0.02 exp(-t / 0.02 s)) / 0.08
  EXPECT_NEAR(norm(later.r - end.r) / norm(start.r - end.r), (0.1 * std::exp(-1) - 0.02 * std::exp(-5)) / 0.08, 0.03)
      << "on an arc";
  EXPECT_NEAR(pinned.robot->base().get(properties::remaining_shift).z / shift.z, 0, 1e-9);
  EXPECT_LT(norm(end.v), 1e-8);
  EXPECT_NEAR(end.R.z.z, 1, 1e-12);
  EXPECT_NEAR(end.r.z, 0.31, 1e-9) << "it stands on its soles";
  EXPECT_LT(difference(shift, {0, 0, stood.z}), 1e-9) << "what was to fade stood in the column";
  EXPECT_LT(difference(pinned.robot->column(properties::position).values[sole], {stood.x, stood.y, 0}), 1e-9);
  EXPECT_LT(difference(turn, rotation_vector(from_matrix(start.R * transpose(end.R)))), 1e-9);
}

/// A limb that swings fast on a robot that flies.
struct Flying {
  explicit Flying(const std::string& level, const catalog::LevelOptions& options = {}) {
    rig.simulation.world().gravity = {};
    robot = &rig.add("robot", std::make_shared<const Model>(fixtures::two_legged()), {.position = {0, 0, 2}});
    rig.attach_dynamics(*robot, {.level = level, .on_ground = false, .options = options});
    rig.simulation.initialize();
  }
  void swing() {
    robot->object("left_hip_pitch").set(properties::joint_velocity, 6);
    robot->object("right_hip_roll").set(properties::joint_velocity, -4);
    robot->object("left_hip_pitch").set(properties::joint_target, 1);
  }
  /// [m/s] of the center of all masses, as the columns of the bodies say.
  [[nodiscard]] Vec3d center_velocity() {
    const Wrenchd p = test::momentum(*robot);
    return (1 / robot->model().tree().mass) * p.f;
  }
  Rig rig;
  Entity* robot = nullptr;
};

// Only the base knows yet what a user has just set; the momentum counts it for the whole robot.
TEST(SimplifiedTakeOver, GoesOnWithTheVelocityThatAUserHasJustSet) {
  Flying flying("full_dynamics");
  flying.rig.simulation.step();
  flying.robot->base().set(properties::linear_velocity, {1, -2, 0.5});
  flying.rig.exchange(*flying.robot, "simplified_dynamics");
  EXPECT_LT(difference(Rig::velocity(*flying.robot), {1, -2, 0.5}), 1e-12);
  EXPECT_LT(difference(flying.center_velocity(), {1, -2, 0.5}), 1e-12);
}

TEST(SimplifiedTakeOver, BodiesMoveSoThatTheCenterDoes) {
  Flying flying("articulated_dynamics");
  flying.swing();
  Rig::launch(*flying.robot, {0.5, -0.7, 0.2}, {1, 2, -0.5});
  flying.rig.run(0.01);
  const Vec3d before = flying.center_velocity();
  flying.rig.exchange(*flying.robot, "simplified_dynamics");
  EXPECT_LT(norm(flying.center_velocity() - before), 1e-12);
  EXPECT_LT(norm(Rig::velocity(*flying.robot) - before), 1e-12);
}

// Rule: with base_rigid the base moves as a rigid body's would, whatever the limbs do: nothing moves it here.
TEST(SimplifiedBaseRigid, LimbsDoNotMoveTheBase) {
  Flying flying("simplified_dynamics", {.base_rigid = true});
  flying.swing();
  const Base before = base_of(*flying.robot);
  double way = 0;
  for (int i = 0; i < 200; ++i) {
    flying.rig.simulation.step();
    way = std::max(way, norm(flying.center_velocity()));
    EXPECT_LT(difference(base_of(*flying.robot).r, before.r), 1e-12);
    EXPECT_LT(norm(base_of(*flying.robot).v), 1e-12);
    EXPECT_LT(norm(Rig::velocity(*flying.robot)), 1e-12) << "the rigid body's velocity: joint rates do not count";
  }
  EXPECT_GT(way, 0.1) << "its limbs did move";
}

// It turns: the base goes round the center of mass of the moment as a point of a rigid body.
TEST(SimplifiedBaseRigid, TurningBaseMovesAsAPointOfARigidBody) {
  Flying flying("simplified_dynamics", {.base_rigid = true});
  Rig::launch(*flying.robot, {0.3, 0.1, 0}, {0.5, -1, 3});
  for (int i = 0; i < 200; ++i) {
    flying.rig.simulation.step();
    const Base now = base_of(*flying.robot);
    const Vec3d c = flying.robot->base().get(properties::common_center_of_mass);
    EXPECT_LT(norm(now.v - (Rig::velocity(*flying.robot) + cross(now.w, now.r - c))), 1e-12);
    EXPECT_LT(norm(Rig::velocity(*flying.robot) - Vec3d{0.3, 0.1, 0}), 1e-9);
  }
}

}  // namespace
}  // namespace murosimf::dynamics
