// What feet feel: together the weight, in the right place; and what is said where a level has no contact forces.
#include "murosimf/sensors/contact_sensors.h"

#include <cmath>
#include <map>

#include "murosimf/collision/contact_properties.h"
#include "murosimf/component_files/sensor_types.h"
#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/locomotion/gait_properties.h"
#include "tests/fixtures.h"
#include "tests/law.h"
#include "tests/physics/rig.h"

namespace murosimf::sensors {
namespace {

/// A robot that stands, with sensors at both soles.
struct Standing {
  explicit Standing(const std::string& level, const std::vector<std::string>& types = {"force_torque"})
      : robot(rig.add("robot", test::kid21())) {
    for (const std::string& type : types) {
      for (const std::string foot : {"l_sole", "r_sole"}) {
        component_files::attach_sensor(rig.simulation, robot, {.name = foot + "_" + type, .type = type, .frame = foot},
                                       {}, rig.rate);
      }
    }
    rig.simulation.attach<locomotion::WalkEngine>("walk_engine", robot, 100);
    rig.attach_motion(robot, {.level = level});
  }
  [[nodiscard]] std::span<const double> numbers(const std::string& sensor, std::string_view output) const {
    return find_reading(robot, sensor)->output(output);
  }
  [[nodiscard]] double weight() const { return robot.model().tree().mass * test::g; }

  test::Rig rig;
  Entity& robot;
};

class Feet : public testing::TestWithParam<std::string> {};

TEST_P(Feet, CarryTheWeight) {
  Standing standing(GetParam(), {"force_torque", "contact_switch", "contact_force", "pressure_cells"});
  standing.rig.run(3);
  const auto left = standing.numbers("l_sole_force_torque", "force");
  const auto right = standing.numbers("r_sole_force_torque", "force");
  law::expect_near({.law = "standing robot: vertical forces of both feet, of its weight",
                    .level = GetParam(),
                    .source = "balance of forces"},
                   (left[2] + right[2]) / standing.weight(), 1, 0.01, "1");
  for (const std::string foot : {"l_sole", "r_sole"}) {
    const auto force = standing.numbers(foot + "_force_torque", "force");
    const double size = norm(Vec3d{force[0], force[1], force[2]});
    EXPECT_NEAR(standing.numbers(foot + "_contact_force", "force")[0], size, 1e-9);
    EXPECT_EQ(standing.numbers(foot + "_contact_switch", "contact")[0], size > 0.1 ? 1 : 0);
    double cells = 0;
    for (const double cell : standing.numbers(foot + "_pressure_cells", "force")) cells += cell;
    EXPECT_NEAR(cells, std::max(0.0, force[2]), 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(ContactSensors, Feet, testing::ValuesIn(test::all_levels()), test::level_name);

class DynamicFeet : public testing::TestWithParam<std::string> {};

// The center of pressure of both feet together lies below the center of mass of a robot at rest.
TEST_P(DynamicFeet, PressBelowTheCenterOfMass) {
  Standing standing(GetParam(), {"pressure_center"});
  standing.rig.run(3);
  Vec3d sum;
  double force = 0;
  for (const std::string foot : {"l_sole", "r_sole"}) {
    const auto center = standing.numbers(foot + "_pressure_center", "center");
    const double f = standing.numbers(foot + "_pressure_center", "force")[0];
    auto sole = standing.robot.object(foot);
    sum += f * (sole.get(properties::position) + sole.get(properties::orientation) * Vec3d{center[0], center[1], 0});
    force += f;
  }
  const Vec3d mass = standing.robot.base().get(properties::common_center_of_mass);
  const Vec3d pressure = (1 / force) * sum;
  law::expect_below({.law = "standing robot: center of pressure away from the center of mass",
                     .level = GetParam(),
                     .source = "balance of moments"},
                    std::hypot(pressure.x - mass.x, pressure.y - mass.y), 1e-3, "m");
}

INSTANTIATE_TEST_SUITE_P(ContactSensors, DynamicFeet, testing::ValuesIn(test::dynamic_levels()), test::level_name);

// A box of 4.3 kg with the sensor shifted and turned: the same force seen from elsewhere.
TEST(ForceTorque, IsTakenAtItsPlaceInItsAxes) {
  test::Rig rig;
  Entity& box = rig.add("box", test::box_model());
  const Mat3d turn = rotation_x(0.5);
  const SensorSpec spec{.name = "f", .type = "force_torque", .position = {0.1, 0.2, 0.05}, .orientation = turn};
  auto& sensor = component_files::attach_sensor(rig.simulation, box, spec, {}, rig.rate);
  rig.attach_dynamics(box);
  rig.run(1);
  const Vec3d weight{0, 0, 4.3 * test::g};
  const auto f = sensor.reading().output("force"), n = sensor.reading().output("torque");
  EXPECT_LT(fixtures::difference(Vec3d{f[0], f[1], f[2]}, transpose(turn) * weight), 0.01 * weight.z);
  EXPECT_LT(fixtures::difference(Vec3d{n[0], n[1], n[2]}, transpose(turn) * cross(Vec3d{-0.1, -0.2, -0.05}, weight)),
            0.01 * weight.z);
}

// A shoe of heel (1 kg) and toe (2 kg), one link: what both feel, with its moment about the heel.
TEST(ForceTorque, IsThatOfAllBodiesOfItsLink) {
  test::Rig rig;
  const auto part = [](Chain& chain, double mass) {
    chain.with(properties::mass, mass)
        .with(properties::inertia, diagonal(0.002 * mass))
        .with(properties::shapes, Shapes{fixtures::placed(Box{{0.05, 0.04, 0.03}})});
  };
  Chain chain = Chain{}.base("heel");
  part(chain, 1);
  chain.translation({0.4, 0, 0}, "toe");
  part(chain, 2);
  Entity& shoe = rig.add("shoe", std::make_shared<const Model>("shoe", chain));
  auto& sensor =
      component_files::attach_sensor(rig.simulation, shoe, {.name = "f", .type = "force_torque"}, {}, rig.rate);
  rig.attach_dynamics(shoe);
  rig.run(1);
  const auto f = sensor.reading().output("force"), n = sensor.reading().output("torque");
  EXPECT_NEAR(f[2], 3 * test::g, 0.01 * 3 * test::g);
  EXPECT_NEAR(n[1], -0.4 * 2 * test::g, 0.01 * 3 * test::g);
}

TEST(ForceTorque, DoesNotFeelAUsersPush) {
  test::Rig rig;
  Entity& box = rig.add("box", test::box_model(), {.position = {0, 0, 5}});
  auto& sensor =
      component_files::attach_sensor(rig.simulation, box, {.name = "f", .type = "force_torque"}, {}, rig.rate);
  rig.attach_dynamics(box, {.on_ground = false});
  rig.simulation.initialize();
  box.base().set(properties::applied_force, {{0, 0, 1}, {30, 0, 0}});
  rig.run(0.1);
  for (const double number : sensor.reading().values) EXPECT_NEAR(number, 0, 1e-9);
}

// The robot leans on its left foot: cells and center must agree with force and moment.
TEST(PressureCells, HaveTheirCenterWhereTheForceIs) {
  Standing standing("simplified_dynamics", {"pressure_cells", "pressure_center"});
  standing.rig.simulation.initialize();
  standing.robot.base().set(properties::applied_force, {{0, 0, 0}, {1.5, 2, 0}});
  standing.rig.run(2);
  const Sole& sole = *standing.robot.model().find(properties::sole, standing.robot.model().object_index("l_sole"));
  const auto cell = standing.numbers("l_sole_pressure_cells", "force");
  const auto center = standing.numbers("l_sole_pressure_center", "center");
  const double force = standing.numbers("l_sole_pressure_center", "force")[0];
  ASSERT_GT(force, 1);
  EXPECT_NEAR((cell[0] + cell[1] - cell[2] - cell[3]) * sole.half_length / force, center[0], 1e-9);
  EXPECT_NEAR((cell[0] - cell[1] + cell[2] - cell[3]) * sole.half_width / force, center[1], 1e-9);
  EXPECT_GT(center[0], 0);
}

TEST(PressureCells, NeedASoleOrTheirSize) {
  test::Rig rig;
  Entity& robot = rig.add("robot", test::kid21());
  const auto error = [&](const SensorSpec& spec) {
    return fixtures::error_of([&] { component_files::attach_sensor(rig.simulation, robot, spec, {}, rig.rate); });
  };
  EXPECT_EQ(error({.name = "a", .type = "pressure_cells", .frame = "torso"}),
            "a: pressure cells that are not mounted on a sole need length and width");
  EXPECT_EQ(error({.name = "b", .type = "pressure_cells", .frame = "l_sole", .numbers = {{"length", -1}}}),
            "b: 'length' is -1; it must be in the range above 0 m");
}

// In the air nothing presses.
TEST(PressureCenter, IsNowhereWithoutPressure) {
  test::Rig rig;
  Entity& box = rig.add("box", test::box_model(), {.position = {0, 0, 5}});
  auto& sensor =
      component_files::attach_sensor(rig.simulation, box, {.name = "p", .type = "pressure_center"}, {}, rig.rate);
  rig.attach_dynamics(box);
  rig.run(0.1);
  EXPECT_TRUE(std::isnan(sensor.reading().values[0]));
  EXPECT_EQ(sensor.reading().values[2], 0);
}

// A walker at kinematic_walking stands on one foot at a time, and the sensor says why.
TEST(ContactSensors, SayWhatTheyReportWithoutContactForces) {
  Standing standing("kinematic_walking", {"contact_switch"});
  auto& sensor = component_files::attach_sensor(standing.rig.simulation, standing.robot,
                                                {.name = "more", .type = "contact_force", .frame = "l_sole"}, {}, 1000);
  EXPECT_EQ(sensor.diagnostic({}), "there are no contact forces: it reports the whole weight on the foot that stands");
  EXPECT_EQ(sensor.diagnostic({.dynamic = true}), "");
  standing.rig.simulation.initialize();
  standing.robot.base().set(properties::walk_command, {0.1, 0, 0});
  std::map<double, int> left;
  for (int i = 0; i < 2000; ++i) {
    standing.rig.simulation.step();
    const double l = standing.numbers("l_sole_contact_switch", "contact")[0];
    const double r = standing.numbers("r_sole_contact_switch", "contact")[0];
    if (i > 0) {
      EXPECT_EQ(l + r, 1);
    }
    ++left[l];
  }
  EXPECT_GT(left[0], 500);
  EXPECT_GT(left[1], 500);
}

}  // namespace
}  // namespace murosimf::sensors
