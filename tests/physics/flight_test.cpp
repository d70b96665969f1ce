// Robots in flight: momentum, energy, and the turn that moving limbs cause.
#include <gtest/gtest.h>

#include "murosimf/dynamics/motion_properties.h"
#include "tests/fixtures.h"
#include "tests/law.h"
#include "tests/physics/limb_swinger.h"
#include "tests/physics/mechanics.h"
#include "tests/physics/rig.h"

namespace murosimf::test {
namespace {

class Flight : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Levels, Flight, testing::Values("full_dynamics", "articulated_dynamics"), level_name);

// Momentum correction, the default. Tolerance: rounding of 2000 steps; without correction 1e-3 to 1e-2 would be lost.
TEST_P(Flight, KeepsItsMomentum) {
  Rig rig;
  Entity& robot = rig.add("robot", kid21(), {.position = {0, 0, 100}});
  rig.simulation.attach<LimbSwinger>("limb_swinger", robot, 100);
  rig.attach_dynamics(robot, {.level = GetParam(), .on_ground = false});
  rig.simulation.initialize();
  Rig::launch(robot, {0.3, 0.2, 0.1}, {1.3, -1.5, 1.2});
  rig.simulation.step();  // takes over the launch
  const Wrenchd start = momentum(robot);
  const double weight = robot.base().get(properties::total_mass) * g;
  law::Worst linear, angular;
  for (int i = 1; i <= 2000; ++i) {
    rig.simulation.step();
    const Wrenchd now = momentum(robot);
    const Vec3d expected = start.f + Vec3d{0, 0, -weight * 1e-3 * i};
    linear.see(norm(now.f - expected) / norm(expected), "step", i);
    angular.see(norm(now.n - start.n) / norm(start.n), "step", i);
  }
  law::expect_below({.law = "flight with swinging limbs: relative error of the momentum in 2 s",
                     .level = GetParam(),
                     .source = "only gravity adds to it"},
                    linear, 1e-12, "");
  law::expect_below({.law = "flight with swinging limbs: relative error of the angular momentum in 2 s",
                     .level = GetParam(),
                     .source = "gravity adds nothing to it"},
                    angular, 1e-12, "");
}

/// Largest relative change of I w of a weightless kid21 that tumbles for 60 s and swings its limbs.
law::Worst drift_of_tumbling(const catalog::LevelOptions& options) {
  Rig rig;
  rig.simulation.world().gravity = {};
  Entity& robot = rig.add("robot", kid21(), {.position = {0, 0, 1}});
  rig.simulation.attach<LimbSwinger>("limb_swinger", robot, 100, true);
  rig.attach_dynamics(robot, {.level = "simplified_dynamics", .on_ground = false, .options = options});
  rig.simulation.initialize();
  Rig::launch(robot, {}, {1.3, -1.5, 1.2});
  const auto angular_momentum = [&] {
    return robot.base().get(properties::common_inertia) * robot.base().get(properties::angular_velocity);
  };
  const Vec3d start = angular_momentum();
  law::Worst drift;
  for (int i = 1; i <= 60000; ++i) {
    rig.simulation.step();
    drift.see(norm(angular_momentum() - start) / norm(start), "step", i);
  }
  return drift;
}

// Rule: only moments from outside change the angular momentum of the composite body, which is all that simplified_dynamics
// knows of it: limbs that swing change its inertia, and so how fast it turns. Tolerance: rounding of 60,000 steps.
TEST(SimplifiedFlight, CompositeBodyKeepsItsAngularMomentum) {
  law::expect_below({.law = "tumbling with swinging limbs: relative error of the composite body's momentum in 60 s",
                     .level = "simplified_dynamics",
                     .source = "nothing outside acts: none"},
                    drift_of_tumbling({}), 1e-10, "");
  // by the letter of the paper w follows Euler's equations, whatever limbs do to the inertia
  const law::Measured rigid = drift_of_tumbling({.base_rigid = true});
  EXPECT_GT(rigid.value, 0.2) << "limbs do change the inertia";
  RecordProperty("base_rigid", fmt::format("{:.3f}", rigid.value));
}

/// Rotation vector [rad] of the base after 2 s of weightless conical swinging, from rest.
Vec3d cat_turn(const std::string& level, double rate_hz) {
  Rig rig(0.8, 0, rate_hz);
  rig.simulation.world().gravity = {};
  Entity& robot = rig.add("robot", kid21(), {.position = {0, 0, 1}});
  rig.simulation.attach<LimbSwinger>("limb_swinger", robot, 100, true);
  rig.attach_dynamics(robot, {.level = level, .on_ground = false});
  rig.run(2.0);
  return rotation_vector(robot.base().get(properties::base_quaternion));
}

// A falling cat: without angular momentum the base turns all the same, by as much as the limbs' way on their cones says.
// Tolerance: 1 % at 1 ms.
TEST_P(Flight, LimbsTurnTheBody) {
  const Vec3d reference = cat_turn(GetParam(), 20000);
  EXPECT_GT(norm(reference), 5 * degree) << "nothing to compare";
  law::expect_below({.law = "falling cat: relative error of the turn by two conical swings of the limbs in 2 s",
                     .level = GetParam(),
                     .source = "the same with steps of 0.05 ms"},
                    norm(cat_turn(GetParam(), 1000) - reference) / norm(reference), 0.01, "");
}

/// Largest relative change of the energy of a tumbling robot with free joints within 2 s.
law::Worst energy_drift(double rate_hz) {
  Rig rig(0.8, 0, rate_hz);
  rig.simulation.world().gravity = {};
  const auto model = std::make_shared<const Model>(fixtures::two_legged());
  Entity& robot = rig.add("robot", model, {.position = {0, 0, 1}});
  rig.attach_dynamics(robot,
                      {.level = "articulated_dynamics", .on_ground = false, .tree = {.momentum_correction = false}});
  rig.simulation.initialize();
  fixtures::Dice dice("energy");
  for (const int joint : model->joints()) {
    robot.object(model->objects()[joint].name).set(properties::joint_velocity, dice.uniform(-2, 2));
  }
  Rig::launch(robot, {0.3, 0.2, 0.1}, {1.3, -1.5, 1.2});
  rig.simulation.step();  // takes over the launch
  const double start = kinetic_energy(robot);
  law::Worst drift;
  for (int i = 0; i < 2 * rate_hz; ++i) {
    rig.simulation.step();
    drift.see(std::abs(kinetic_energy(robot) / start - 1), "step", i);
  }
  return drift;
}

// Semi-implicit Euler is of first order: half the step, half the drift.
TEST(Tumbling, EnergyDriftIsOfFirstOrder) {
  const std::string level = "articulated_dynamics, without momentum correction";
  const law::Measured at_1_ms = energy_drift(1000), at_half_ms = energy_drift(2000);
  law::expect_below({.law = "robot with free joints tumbles: relative change of its energy in 2 s",
                     .level = level,
                     .source = "nothing works on it: none"},
                    at_1_ms, 0.02, "");
  law::expect_near({.law = "robot with free joints tumbles: change of its energy with half the step, as a part",
                    .level = level,
                    .source = "integration of first order"},
                   at_half_ms.value / at_1_ms.value, 0.5, 0.1, "");
}

}  // namespace
}  // namespace murosimf::test
