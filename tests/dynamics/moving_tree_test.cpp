// The base of levels with links: bolted or free, pushed in flight, what users change, and when it is refused.
#include "murosimf/dynamics/moving_tree.h"
#include "murosimf/collision/contact_properties.h"
#include "murosimf/dynamics/motion_properties.h"

#include <gtest/gtest.h>

#include "tests/fixtures.h"
#include "tests/physics/mechanics.h"
#include "tests/physics/rig.h"

namespace murosimf::dynamics {
namespace {

using fixtures::difference;
using test::Rig;

struct Flying {
  explicit Flying(const std::string& level, const MovingTreeOptions& tree = {}) {
    rig.simulation.world().gravity = {0.3, -0.2, -5};
    robot = &rig.add("robot", std::make_shared<const Model>(fixtures::two_legged()), {.position = {0, 0, 20}});
    rig.attach_dynamics(*robot,
                        {.level = level, .law = test::law_named("kelvin_voigt"), .on_ground = false, .tree = tree});
    rig.simulation.initialize();
  }
  Rig rig;
  Entity* robot = nullptr;
};

class TreeLevel : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Levels, TreeLevel, testing::Values("full_dynamics", "articulated_dynamics"), test::level_name);

// In flight momentum grows by exactly what gravity and pushes give, force by force at its body.
TEST_P(TreeLevel, PushesInFlightGiveTheirImpulse) {
  Flying flying(GetParam());
  Rig::launch(*flying.robot, {1, 2, 3}, {0.5, -1, 2});
  flying.robot->object("left_knee").set(properties::joint_velocity, 3);
  flying.rig.simulation.step();
  const Vec3d force{0.7, -1.1, 2}, moment{0.2, 0.1, -0.3};
  flying.robot->object("right_foot").set(properties::applied_force, Wrenchd{moment, force});
  const double m = flying.robot->model().tree().mass;
  for (int i = 0; i < 100; ++i) {
    const Wrenchd before = test::momentum(*flying.robot);
    const Vec3d arm = flying.robot->object("right_foot").get(properties::position) -
                      flying.robot->base().get(properties::common_center_of_mass);
    const Vec3d center = flying.robot->base().get(properties::common_center_of_mass);
    flying.rig.simulation.step();
    const Wrenchd after = test::momentum(*flying.robot);
    EXPECT_LT(difference(after.f, before.f + 1e-3 * (m * Vec3d{0.3, -0.2, -5} + force)), 1e-12) << i;
    EXPECT_LT(difference(after.n, before.n + 1e-3 * (moment + cross(arm, force))), 1e-12) << i;
    EXPECT_LT(difference(flying.robot->base().get(properties::common_center_of_mass), center + (1e-3 / m) * after.f),
              1e-12)
        << i;
  }
}

// What the level reports of the whole robot, against sums over its bodies.
TEST_P(TreeLevel, CommonMassIsThatOfAllBodies) {
  Flying flying(GetParam());
  Rig::launch(*flying.robot, {1, 2, 3}, {0.5, -1, 2});
  flying.robot->object("left_knee").set(properties::joint_velocity, 3);
  flying.rig.run(0.05);
  const auto base = flying.robot->base();
  double mass = 0;
  Vec3d first, momentum;
  const auto bodies = test::moving_bodies(*flying.robot);
  for (const auto& body : bodies) {
    mass += body.mass;
    first += body.mass * body.center;
    momentum += body.mass * body.velocity;
  }
  const Vec3d center = (1 / mass) * first;
  SymMat3d inertia;
  for (const auto& body : bodies) inertia += body.inertia + body.mass * inertia_of_point(body.center - center);
  EXPECT_NEAR(base.get(properties::total_mass), mass, 1e-12);
  EXPECT_LT(difference(base.get(properties::common_center_of_mass), center), 1e-12);
  EXPECT_LT(difference(base.get(properties::common_center_of_mass_velocity), (1 / mass) * momentum), 1e-12);
  EXPECT_LT(difference(base.get(properties::common_inertia), inertia), 1e-12);
}

// Two boxes fly against each other: an island solves those steps, Runge-Kutta all others, which know nothing of them.
TEST_P(TreeLevel, FliesOnAfterATouch) {
  Rig rig;
  rig.simulation.world().gravity = {};
  Entity& fast = rig.add("fast", test::box_model(), {.position = {0, 0, 5}});
  Entity& slow = rig.add("slow", test::box_model(), {.position = {0.4, 0.05, 5}});
  const test::Dynamics dynamics{.level = GetParam(),
                                .law = test::law_named("kelvin_voigt"),
                                .on_ground = false,
                                .tree = {.integrator = Integrator::rk4}};
  rig.attach_together({{&fast, dynamics}, {&slow, dynamics}});
  rig.simulation.initialize();
  Rig::launch(fast, {1, 0, 0});
  rig.run(0.5);
  EXPECT_GT(Rig::velocity(slow).x, 0.3) << "they have touched";
  for (Entity* box : {&fast, &slow}) {
    const Vec3d before = Rig::place(*box), v = Rig::velocity(*box);
    rig.run(0.1);
    EXPECT_LT(difference(Rig::velocity(*box), v), 1e-9);
    EXPECT_LT(difference(Rig::place(*box), before + 0.1 * v), 1e-9);
  }
}

TEST_P(TreeLevel, BoltedBaseStaysWhateverIsSet) {
  for (const Integrator integrator : {Integrator::semi_implicit_euler, Integrator::rk4}) {
    Flying flying(GetParam(), {.integrator = integrator, .fixed_base = true});
    const Vec3d place = Rig::place(*flying.robot);
    flying.robot->base().set(properties::linear_velocity, {1, 2, 3});
    flying.robot->base().set(properties::angular_velocity, {1, 2, 3});
    flying.robot->base().set(properties::applied_force, Wrenchd{{1, 1, 1}, {10, 10, 10}});
    flying.robot->object("left_hip_pitch").set(properties::joint_target, 0.8);
    flying.rig.run(0.2);
    EXPECT_EQ(difference(Rig::place(*flying.robot), place), 0);
    EXPECT_EQ(norm(flying.robot->base().get(properties::linear_velocity)), 0);
    EXPECT_EQ(norm(flying.robot->base().get(properties::angular_velocity)), 0);
    EXPECT_LT(difference(flying.robot->base().get(properties::orientation), Mat3d{}), 1e-15);
  }
}

// A level that bolts the base takes the motion out of it, whatever the level before did.
TEST_P(TreeLevel, BoltingTakesTheMotionOutOfTheBase) {
  Flying flying("simplified_dynamics");
  Rig::launch(*flying.robot, {1, 2, 3}, {1, -2, 3});
  flying.rig.run(0.01);
  const Vec3d place = Rig::place(*flying.robot);
  catalog::LevelOptions options;
  options.tree.fixed_base = true;
  flying.rig.exchange(*flying.robot, GetParam(), options);
  EXPECT_EQ(norm(flying.robot->base().get(properties::linear_velocity)), 0);
  EXPECT_EQ(norm(flying.robot->base().get(properties::angular_velocity)), 0);
  flying.rig.run(0.05);
  EXPECT_EQ(difference(Rig::place(*flying.robot), place), 0);
}

TEST_P(TreeLevel, ChangesOfUsersActInTheNextStep) {
  Flying flying(GetParam());
  flying.robot->base().set(properties::base_quaternion, exponential(Vec3d{0.3, -0.4, 1}));
  flying.robot->base().set(properties::position, {5, 6, 30});
  flying.rig.simulation.step();
  EXPECT_LT(difference(flying.robot->base().get(properties::orientation), to_matrix(exponential(Vec3d{0.3, -0.4, 1}))),
            1e-4);
  EXPECT_LT(difference(Rig::place(*flying.robot), {5, 6, 30}), 1e-4);
}

TEST_P(TreeLevel, NumbersThatHaveGoneBadFreezeIt) {
  for (const Vec3d& v : {Vec3d{2000, 0, 0}, {0, 0, std::nan("")}}) {
    Flying flying(GetParam());
    flying.rig.simulation.step();
    EXPECT_EQ(flying.robot->base().get(properties::dynamic), 1);
    flying.robot->base().set(properties::linear_velocity, v);
    flying.rig.simulation.step();
    ASSERT_TRUE(flying.robot->frozen());
    EXPECT_TRUE(fixtures::says(*flying.robot->frozen_reason(), {"1000 m/s"}));
    EXPECT_EQ(norm(flying.robot->base().get(properties::linear_velocity)), 0);
    EXPECT_EQ(norm(Rig::velocity(*flying.robot)), 0);
    EXPECT_EQ(flying.robot->base().get(properties::dynamic), 0);
  }
}

// Rule: a state keeps in mind whether a user's change still waits for its step, whatever users change after it was loaded.
TEST_P(TreeLevel, StateKnowsWhetherAChangeWaits) {
  for (const int waiting : {0, 1, 2}) {
    for (const int later : {0, 1, 2}) {
      Flying first(GetParam()), second(GetParam());
      const auto turn = [](Flying& flying, double angle) {
        flying.robot->base().set(properties::base_quaternion, exponential(Vec3d{angle, -0.3, 0.2}));
      };
      first.rig.run(0.01);
      for (int i = 0; i < waiting; ++i) turn(first, 0.5 + 0.1 * i);
      const auto state = first.rig.simulation.save();
      second.rig.simulation.load(state);
      for (Flying* flying : {&first, &second}) {
        for (int i = 0; i < later; ++i) turn(*flying, -0.5 - 0.1 * i);
        flying->rig.simulation.step();
      }
      EXPECT_EQ(first.rig.simulation.state_hash(), second.rig.simulation.state_hash()) << waiting << " " << later;
      if (waiting + later == 0) continue;
      const double angle = later > 0 ? -0.4 - 0.1 * later : 0.4 + 0.1 * waiting;
      EXPECT_LT(difference(second.robot->base().get(properties::orientation),
                           to_matrix(exponential(Vec3d{angle, -0.3, 0.2}))),
                0.01);
    }
  }
}

}  // namespace
}  // namespace murosimf::dynamics
