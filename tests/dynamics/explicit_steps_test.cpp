// Steps of several stages, at every level: contacts, what users change, and forces that fall with the velocity.
#include <gtest/gtest.h>

#include "murosimf/collision/contact_properties.h"
#include "murosimf/dynamics/motion_properties.h"
#include "tests/fixtures.h"
#include "tests/physics/rig.h"

namespace murosimf::dynamics {
namespace {

using fixtures::difference;
using test::Rig;

// A box on a slope of 10 degrees sticks, with the springs of its contacts as memory, however its steps are made.
TEST(ExplicitSteps, StandOnASlope) {
  for (const std::string& level : test::dynamic_levels()) {
    Vec3d rest[2];
    for (const Integrator integrator : {Integrator::rk4, Integrator::semi_implicit_euler}) {
      Rig rig(0.8, 10 * test::degree);
      Entity& box = rig.add("box", test::box_model());
      rig.attach_dynamics(box,
                          {.level = level, .law = test::law_named("kelvin_voigt"), .tree = {.integrator = integrator}});
      rig.run(1);
      const Vec3d before = Rig::place(box);
      rig.run(1);
      rest[integrator == Integrator::rk4 ? 0 : 1] = Rig::place(box);
      EXPECT_LT(difference(Rig::place(box), before), 1e-5) << level;
      Vec3d force;
      for (const auto& c : box.find(collision::contacts)->values[0].points) force += c.force;
      EXPECT_LT(difference(force, -4.3 * rig.simulation.world().gravity), 0.05) << level;
    }
    EXPECT_LT(difference(rest[0], rest[1]), 1e-4) << level;
  }
}

// Rule: a contact's spring is stretched by one step's way in one step, of however many stages that is made. A box slides
// with 5 mm/s, which its contacts hold.
TEST(ExplicitSteps, StretchTheSpringsOfContactsOnce) {
  for (const std::string& level : test::dynamic_levels()) {
    Rig rig;
    Entity& box = rig.add("box", test::box_model());
    rig.attach_dynamics(box, {.level = level,
                              .law = test::law_named("kelvin_voigt"),
                              .tree = {.integrator = Integrator::rk4}});
    rig.run(1);
    const auto stretch = [&] { return box.find(collision::contacts)->values[0].points.at(0).stretch; };
    const Vec3d before = stretch(), place = Rig::place(box);
    Rig::launch(box, {0.003, -0.004, 0});
    rig.simulation.step();
    const Vec3d way = Rig::place(box) - place;
    EXPECT_GT(norm(way), 3e-6) << level;
    EXPECT_LT(difference(stretch() - before, {way.x, way.y, 0}), 0.5 * norm(way)) << level;
  }
}

// Rule: what users change acts in the next step, with every integrator.
TEST(ExplicitSteps, TakeChangesOfUsers) {
  for (const std::string level : {"full_dynamics", "articulated_dynamics"}) {
    for (const Integrator integrator : {Integrator::rk4, Integrator::semi_implicit_euler}) {
      Rig rig;
      rig.simulation.world().gravity = {};
      Entity& robot = rig.add("robot", std::make_shared<const Model>(fixtures::two_legged()), {.position = {0, 0, 5}});
      rig.attach_dynamics(robot, {.level = level,
                                  .law = test::law_named("kelvin_voigt"),
                                  .on_ground = false,
                                  .tree = {.integrator = integrator}});
      rig.run(0.01);
      const Mat3d turn = to_matrix(exponential(Vec3d{0.5, 0.2, -1}));
      robot.base().set(properties::base_quaternion, from_matrix(turn));
      robot.base().set(properties::linear_velocity, {1, 2, 3});
      const Vec3d before = Rig::place(robot);
      rig.simulation.step();
      EXPECT_LT(difference(robot.base().get(properties::orientation), turn), 1e-6) << level;
      EXPECT_LT(difference(Rig::place(robot), before + 1e-3 * Vec3d{1, 2, 3}), 1e-6) << level;
    }
  }
}

// Law: stages are explicit, so that a push is what it is at their instant; how fast it falls with the velocity is for
// implicit steps. h F / m of a box of 4.3 kg.
TEST(ExplicitSteps, KnowNoDampingOfForces) {
  const Vec3d push{3, -8, 5};  // [N]
  Sym6d damping;
  damping.M = diagonal(40.0);  // [N s/m]
  for (const std::string& level : test::dynamic_levels()) {
    Rig rig;
    rig.simulation.world().gravity = {};
    Entity& box = rig.add("box", test::box_model(), {.position = {0, 0, 5}});
    rig.attach_dynamics(box, {.level = level,
                              .law = test::law_named("kelvin_voigt"),
                              .on_ground = false,
                              .tree = {.integrator = Integrator::rk4}});
    rig.simulation.initialize();
    box.base().set(properties::applied_force, {{}, push});
    box.column(properties::external_damping).values[0] = damping;
    rig.simulation.step();
    EXPECT_LT(difference(Rig::velocity(box), (1e-3 / 4.3) * push), 1e-9) << level;
  }
}

}  // namespace
}  // namespace murosimf::dynamics
