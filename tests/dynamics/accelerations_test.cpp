// Accelerations of objects and joints: closed forms, and what an accelerometer at the same place feels.
#include "murosimf/dynamics/accelerations.h"

#include <gtest/gtest.h>

#include "murosimf/component_files/sensor_types.h"
#include "murosimf/scene/scene.h"
#include "tests/fixtures.h"
#include "tests/law.h"
#include "tests/physics/limb_swinger.h"
#include "tests/physics/rig.h"
#include "tests/written_scene.h"

namespace murosimf::dynamics {
namespace {

using fixtures::difference;
using test::g;
using test::Rig;

void attach_accelerations(Rig& rig, Entity& entity) {
  rig.simulation.attach<Accelerations>("accelerations", entity, rig.rate);
}

/// An arm of 0.8 kg, its center at 0.15 m, that turns about y without servo; its hand is 0.3 m away.
ModelPtr pendulum() {
  return std::make_shared<const Model>("pendulum", Chain{}
                                                       .base("stand")
                                                       .with(properties::mass, 2.0)
                                                       .with(properties::inertia, diagonal(0.1))
                                                       .revolute("arm", {0, 1, 0})
                                                       .with(properties::mass, 0.8)
                                                       .with(properties::center_of_mass, {0.15, 0, 0})
                                                       .with(properties::inertia, diagonal(0.002))
                                                       .translation({0.3, 0, 0})
                                                       .endpoint("hand")
                                                       .structural());
}

struct Pendulum {
  explicit Pendulum(const Vec3d& gravity) : robot(rig.add("pendulum", pendulum(), {.position = {0, 0, 2}})) {
    rig.simulation.world().gravity = gravity;
    rig.attach_dynamics(robot, {.level = "articulated_dynamics", .on_ground = false, .tree = {.fixed_base = true}});
    attach_accelerations(rig, robot);
    rig.simulation.initialize();
  }
  [[nodiscard]] double angle() { return robot.object("arm").get(properties::joint_position); }
  [[nodiscard]] double rate() { return robot.object("arm").get(properties::joint_velocity); }
  Rig rig;
  Entity& robot;
};

TEST(Accelerations, FreeFallIsGravity) {
  for (const std::string& level : test::dynamic_levels()) {
    Rig rig;
    Entity& robot = rig.add("robot", test::kid21(), {.position = {0, 0, 50}});
    rig.attach_dynamics(robot, {.level = level, .on_ground = false, .tree = {.momentum_correction = false}});
    attach_accelerations(rig, robot);
    rig.simulation.initialize();
    EXPECT_EQ(norm(robot.object("torso").get(properties::linear_acceleration)), 0) << "no step has ended yet";
    law::Worst error;
    for (int i = 0; i < 100; ++i) {
      rig.simulation.step();
      for (const char* object : {"pelvis", "torso", "l_foot"}) {
        error.see(difference(robot.object(object).get(properties::linear_acceleration), {0, 0, -g}), level, object, i);
        error.see(norm(robot.object(object).get(properties::angular_acceleration)), level, object, i);
      }
    }
    law::expect_below({.law = "free fall at rest: error of the accelerations of links",
                       .level = level,
                       .source = "g, and no turning"},
                      error, 1e-7, "m/s^2");
  }
}

// Law: m r_c g cos(q) / (I + m r_c^2), q below the horizontal: that of a step is at the angle before it.
TEST(Accelerations, PendulumFallsAsItsEquationSays) {
  Pendulum pendulum({0, 0, -g});
  law::Worst error;
  for (int i = 0; i < 500; ++i) {
    const double expected = 0.8 * 0.15 * g * std::cos(pendulum.angle()) / (0.002 + 0.8 * 0.15 * 0.15);
    pendulum.rig.simulation.step();
    error.see(std::abs(pendulum.robot.object("arm").get(properties::joint_acceleration) - expected), "step", i);
    EXPECT_NEAR(pendulum.robot.object("arm").get(properties::angular_acceleration).y,
                pendulum.robot.object("arm").get(properties::joint_acceleration), 1e-9);
  }
  law::expect_below({.law = "pendulum: error of the joint's acceleration",
                     .level = "articulated_dynamics",
                     .source = "m r g cos(q) / (I + m r^2)"},
                    error, 1e-9, "rad/s^2");
}

// Law: w^2 r towards the axis. The hand is a structural object: its acceleration is worked out of its link's.
TEST(Accelerations, TurningArmsHandIsPulledInwards) {
  Pendulum pendulum({});
  pendulum.robot.object("arm").set(properties::joint_velocity, 4);
  pendulum.rig.simulation.step();  // from rest, for the accelerations
  law::Worst error;
  for (int i = 0; i < 500; ++i) {
    pendulum.rig.simulation.step();
    EXPECT_NEAR(pendulum.rate(), 4, 1e-9);
    const double q = pendulum.angle();
    const Vec3d inwards{-std::cos(q), 0, std::sin(q)};
    const Vec3d a = pendulum.robot.object("hand").get(properties::linear_acceleration);
    error.see(difference(a, 16 * 0.3 * inwards), "step", i);
  }
  law::expect_below({.law = "hand on an arm of 0.3 m that turns with 4 rad/s: error of its acceleration",
                     .level = "articulated_dynamics",
                     .source = "w^2 r, inwards"},
                    error, 0.01, "m/s^2");
}

class AtEveryLevel : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Accelerations, AtEveryLevel, testing::ValuesIn(test::all_levels()), test::level_name);

// f = R^T (a - g) of the same step, R the mean of its ends: exactly what an accelerometer without errors shows.
TEST_P(AtEveryLevel, AccelerometerFeelsThemLessGravity) {
  Rig rig;
  Entity& robot = rig.add("robot", test::kid21());
  rig.simulation.attach<test::LimbSwinger>("limb_swinger", robot, 100);
  auto& sensor = component_files::attach_sensor(rig.simulation, robot,
                                                {.name = "a", .type = "accelerometer", .frame = "torso", .rate = 1000},
                                                {}, rig.rate);
  rig.attach_motion(robot, {.level = GetParam()});
  attach_accelerations(rig, robot);
  rig.simulation.initialize();
  law::Worst error;
  double largest = 0;
  Vec3d felt;
  Mat3d before = robot.object("torso").get(properties::orientation);
  for (int i = 0; i < 1000; ++i) {
    rig.simulation.step();
    if (i > 1) {  // sensors see what the step before has left
      const auto f = sensor.reading().output("accelerometer");
      error.see(difference({f[0], f[1], f[2]}, felt), "step", i);
    }
    const Vec3d a = robot.object("torso").get(properties::linear_acceleration);
    const Mat3d R = robot.object("torso").get(properties::orientation);
    felt = 0.5 * (transpose(before) * (a + Vec3d{0, 0, g}) + transpose(R) * (a + Vec3d{0, 0, g}));
    largest = std::max(largest, norm(a));
    before = R;
  }
  EXPECT_GT(largest, 0.1) << "it moves";
  law::expect_below({.law = "swinging limbs: specific force less R^T (a - g)",
                     .level = GetParam(),
                     .source = "what an accelerometer at the same place shows"},
                    error, 1e-9, "m/s^2");
}

// Velocities add up: nothing of a change of velocity is missing, also while feet swap.
TEST_P(AtEveryLevel, AddUpToTheVelocity) {
  const auto written =
      "[[robots]]\nname = 'walker'\nmodel = 'kid21'\nsensors = false\naccelerations = true\n"
      "controller = 'walk'\ncommand = [0.2, 0, 0]\nlevel = '" +
      GetParam() + "'\n";
  scene::Scene scene(fixtures::write_scene(written));
  Entity& robot = scene.simulation().world().entity("walker");
  scene.simulation().run(from_seconds(0.5));
  const Vec3d start = robot.object("l_foot").get(properties::linear_velocity);
  Vec3d sum;
  for (int i = 0; i < 1000; ++i) {
    scene.simulation().step();
    sum += 1e-3 * robot.object("l_foot").get(properties::linear_acceleration);
  }
  EXPECT_LT(difference(sum, robot.object("l_foot").get(properties::linear_velocity) - start), 1e-9);
}

/// State hash of a short walk, saved and loaded on its way.
std::uint64_t hash_of_walk(const std::string& extra, Vec3d& last) {
  scene::Scene scene(
      fixtures::write_scene("[[robots]]\nname = 'walker'\nmodel = 'kid21'\ncontroller = 'walk'\n"
                            "command = [0.2, 0, 0]\n" +
                            extra));
  scene.simulation().run(from_seconds(0.3));
  const auto state = scene.save();
  scene.simulation().run(from_seconds(0.2));
  scene.load(state);
  scene.simulation().step();
  if (!extra.empty()) {
    last = scene.simulation().world().entity("walker").base().get(properties::linear_acceleration);
  }
  return scene.simulation().state_hash();
}

// Rule: observation changes nothing, and a loaded state goes on with the accelerations of its own.
TEST(Accelerations, LookingChangesNothing) {
  Vec3d loaded, none;
  EXPECT_EQ(hash_of_walk("accelerations = true\n", loaded), hash_of_walk("", none));
  scene::Scene straight(
      fixtures::write_scene("[[robots]]\nname = 'walker'\nmodel = 'kid21'\ncontroller = 'walk'\n"
                            "command = [0.2, 0, 0]\naccelerations = true\n"));
  straight.simulation().run(from_seconds(0.3));
  straight.simulation().step();
  EXPECT_EQ(difference(straight.simulation().world().entity("walker").base().get(properties::linear_acceleration),
                       loaded),
            0);
  scene::Scene without(fixtures::write_scene("[[robots]]\nname = 'walker'\nmodel = 'kid21'\n"));
  EXPECT_EQ(without.simulation().world().entity("walker").find(properties::linear_acceleration), nullptr);
}

}  // namespace
}  // namespace murosimf::dynamics
