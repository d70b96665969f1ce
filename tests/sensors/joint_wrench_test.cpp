// Force and moment through joints and welds: weights, a swinging pendulum, feet; signs and axes.
#include "murosimf/sensors/joint_wrench.h"

#include <gtest/gtest.h>

#include "murosimf/collision/contact_properties.h"
#include "murosimf/component_files/sensor_types.h"
#include "murosimf/model/properties.h"
#include "tests/fixtures.h"
#include "tests/law.h"
#include "tests/physics/rig.h"

namespace murosimf::sensors {
namespace {

struct Wrench {
  Vec3d force, torque;
};

Wrench wrench_of(const Sensor& sensor) {
  return {vector_of(sensor.reading().output("force")), vector_of(sensor.reading().output("torque"))};
}

Chain& with_mass(Chain& chain, double mass, const Vec3d& center = {}) {
  return chain.with(properties::mass, mass)
      .with(properties::center_of_mass, center)
      .with(properties::inertia, diagonal(0.002 * mass));
}

/// A base of 3 kg whose hand of 1 kg at a hinge about y has its center 0.2 m ahead of it.
ModelPtr hanging_hand(bool servo) {
  Chain chain = Chain{}.base("base");
  with_mass(chain, 3).translation({0, 0, 0.3}, "offset").revolute("wrist", {0, 1, 0});
  if (servo) chain.with(properties::servo, {.law = "ideal_pd", .position_gain = 1e5, .velocity_gain = 1e3});
  with_mass(chain, 1, {0.2, 0, 0});
  return std::make_shared<const Model>("hand", chain);
}

test::Dynamics bolted(const std::string& level) {
  return {.level = level, .on_ground = false, .tree = {.fixed_base = true}};
}

class BoltedLevels : public testing::TestWithParam<std::string> {};

TEST_P(BoltedLevels, ShowTheWeightOfWhatHangs) {
  test::Rig rig;
  Entity& robot = rig.add("robot", hanging_hand(true), {.position = {0, 0, 1}});
  const SensorSpec spec{.name = "f", .type = "joint_wrench", .frame = "wrist"};
  const auto& sensor = component_files::attach_sensor(rig.simulation, robot, spec, {}, rig.rate);
  rig.attach_dynamics(robot, bolted(GetParam()));
  rig.run(0.5);
  const auto [force, torque] = wrench_of(sensor);
  law::expect_near({.law = "hand of 1 kg that hangs on its wrist: force", .level = GetParam(), .source = "m g"},
                   norm(force - Vec3d{0, 0, -test::g}), 0, 1e-3, "N");
  law::expect_near({.law = "hand of 1 kg, 0.2 m ahead of its wrist: moment", .level = GetParam(), .source = "m g l"},
                   norm(torque - Vec3d{0, 0.2 * test::g, 0}), 0, 1e-3, "N m");
}

INSTANTIATE_TEST_SUITE_P(JointWrench, BoltedLevels, testing::Values("full_dynamics", "articulated_dynamics"),
                         test::level_name);

// Free hinge, released level: phi is how far the hand has fallen. About the hinge nothing is passed on.
// Tolerance: first order in the step, accelerations change by 30 m/s^2 in a second.
TEST(JointWrench, OfASwingingPendulumIsThatOfItsClosedForm) {
  test::Rig rig;
  Entity& robot = rig.add("robot", hanging_hand(false), {.position = {0, 0, 1}});
  const SensorSpec spec{.name = "f", .type = "joint_wrench", .texts = {{"axes", "base"}}};
  SensorSpec at_wrist = spec;
  at_wrist.frame = "wrist";
  const auto& sensor = component_files::attach_sensor(rig.simulation, robot, at_wrist, {}, rig.rate);
  rig.attach_dynamics(robot, bolted("articulated_dynamics"));
  rig.simulation.initialize();
  const double m = 1, l = 0.2, inertia = 0.002 + m * l * l;
  law::Worst force_error, moment_error;
  for (int i = 0; i < 400; ++i) {
    const double phi = robot.object("wrist").get(properties::joint_position);
    const double rate = robot.object("wrist").get(properties::joint_velocity);
    rig.simulation.step();
    if (i == 0) continue;  // nothing was before
    const double turn = m * test::g * l * std::cos(phi) / inertia;
    const Vec3d ahead{std::cos(phi), 0, -std::sin(phi)}, down{-std::sin(phi), 0, -std::cos(phi)};
    const Vec3d acceleration = l * turn * down - l * rate * rate * ahead;
    const auto [force, torque] = wrench_of(sensor);
    force_error.see(norm(force - (-m * (acceleration + Vec3d{0, 0, test::g}))), "time", 1e-3 * i);
    moment_error.see(norm(torque), "time", 1e-3 * i);
  }
  law::expect_below({.law = "pendulum of 1 kg that falls from level: force on its hinge, error",
                     .level = "articulated_dynamics",
                     .source = "m (g - a), a of the closed form"},
                    force_error, 0.2, "N");
  law::expect_below({.law = "pendulum of 1 kg that falls from level: moment on its hinge",
                     .level = "articulated_dynamics",
                     .source = "a free hinge passes on none"},
                    moment_error, 0.05, "N m");
}

/// A body of 5 kg on a foot of 1 kg that is fixed 0.3 m below it and turned by a right angle.
ModelPtr standing() {
  Chain chain = Chain{}.base("base");
  with_mass(chain, 5).translation({0, 0, -0.3}, "offset").rotation({0, 0, 1}, pi / 2, "foot");
  with_mass(chain, 1).with(properties::shapes, Shapes{fixtures::placed(Box{{0.2, 0.2, 0.05}})}).endpoint("tip");
  return std::make_shared<const Model>("standing", chain);
}

class Standing : public testing::TestWithParam<std::string> {};

TEST_P(Standing, IsMeasuredInBothDirectionsAndInAllAxes) {
  test::Rig rig;
  Entity& robot = rig.add("robot", standing(), {.position = {0, 0, 0.35}});
  const auto attach = [&](const std::string& name, std::map<std::string, std::string> texts) -> const Sensor& {
    texts["behind"] = "foot";
    const SensorSpec spec{.name = name, .type = "joint_wrench", .frame = "foot", .texts = std::move(texts)};
    return component_files::attach_sensor(rig.simulation, robot, spec, {}, rig.rate);
  };
  const auto& child = attach("child", {});
  const auto& parent = attach("parent", {{"axes", "base"}, {"direction", "parent_to_child"}});
  rig.attach_dynamics(robot, {.level = GetParam()});
  rig.simulation.initialize();
  robot.base().set(properties::applied_force, Wrenchd{{}, {4, 0, 0}});
  rig.run(2);
  const Wrench up = wrench_of(child), down = wrench_of(parent);
  // in axes of the foot, x of the world is -y
  law::expect_near({.law = "5 kg on a foot, pushed by 4 N: force of the foot", .level = GetParam(), .source = "m g"},
                   norm(up.force - Vec3d{0, 4, 5 * test::g}), 0, 0.05, "N");
  EXPECT_LT(norm(down.force - Vec3d{4, 0, -5 * test::g}), 0.05);
  EXPECT_LT(norm(Vec3d{down.torque.y + up.torque.x, 0, 0}) + std::abs(down.torque.x - up.torque.y), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(JointWrench, Standing, testing::ValuesIn(test::dynamic_levels()), test::level_name);

TEST(JointWrench, RefusesWhatItDoesNotKnow) {
  const auto what = [](std::map<std::string, std::string> texts) {
    return fixtures::error_of([&] {
      test::Rig rig;
      Entity& robot = rig.add("robot", standing());
      const SensorSpec spec{.name = "f", .type = "joint_wrench", .texts = std::move(texts)};
      (void)component_files::attach_sensor(rig.simulation, robot, spec, {}, rig.rate);
    });
  };
  EXPECT_TRUE(fixtures::says(what({{"behind", "fot"}}), {"did you mean 'foot'?"}));
  EXPECT_TRUE(fixtures::says(what({{"axes", "bas"}}), {"did you mean 'base'?"}));
  EXPECT_TRUE(fixtures::says(what({{"direction", "down"}}), {"direction"}));
  EXPECT_TRUE(fixtures::says(what({{"behind", "tip"}}), {"nothing is behind 'tip'", "the TOML file beside it"}));
}

}  // namespace
}  // namespace murosimf::sensors
