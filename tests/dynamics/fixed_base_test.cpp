/// fixed_base_test - a model whose base is bolted to the world keeps its place at every level, and only its joints move.
#include "murosimf/model/fixed_base.h"

#include <cmath>

#include <gtest/gtest.h>

#include "murosimf/dynamics/motion_properties.h"
#include "tests/fixtures.h"
#include "tests/physics/rig.h"

namespace murosimf::dynamics {
namespace {

using fixtures::difference;
using test::Rig;

constexpr double mass = 2, arm = 0.4, inertia = 0.05;  // [kg, m, kg m^2 at the center of mass]

/// A pendulum below a base without mass, whose joint has a servo if `driven`.
ModelPtr pendulum(bool driven) {
  Chain chain = Chain{}.base("world").with(properties::fixed_base, 1);
  chain.translation({0, 0, 1.5}).revolute("j", {0, 1, 0});
  chain.with(properties::mass, mass).with(properties::center_of_mass, {0, 0, -arm});
  chain.with(properties::inertia, diagonal(inertia)).with(properties::shapes, Shapes{{.shape = Sphere{0.6}}});
  if (driven) chain.with(properties::servo, {.law = "ideal_pd", .position_gain = 400, .velocity_gain = 40});
  return std::make_shared<const Model>("pendulum", chain);
}

struct Bolted {
  Bolted(const std::string& level, bool driven) {
    robot = &rig.add("robot", pendulum(driven), {.position = {1, 2, 3}, .heading = 0.5});
    rig.attach_motion(*robot, {.level = level, .on_ground = false});
    rig.simulation.initialize();
  }
  double joint(const Property<double>& property) { return robot->object("j").get(property); }

  Rig rig{0.8, 0, 1000};
  Entity* robot;
};

class FixedBase : public testing::TestWithParam<const char*> {};

TEST_P(FixedBase, StaysWhereItIsWhileJointsMove) {
  Bolted bolted(GetParam(), true);
  const Mat3d attitude = bolted.robot->base().get(properties::orientation);
  bolted.robot->object("j").set(properties::joint_target, 0.7);
  for (int i = 0; i < 1000; ++i) {
    bolted.rig.simulation.step();
    ASSERT_EQ(difference(bolted.robot->base().get(properties::position), Vec3d{1, 2, 3}), 0) << "in step " << i;
  }
  EXPECT_EQ(norm(bolted.robot->base().get(properties::orientation).x - attitude.x), 0);
  EXPECT_EQ(difference(bolted.robot->base().get(properties::linear_velocity), Vec3d{}), 0);
  EXPECT_NEAR(bolted.joint(properties::joint_position), 0.7, 0.05);
  const Vec3d joint = bolted.robot->object("j").get(properties::position);
  EXPECT_NEAR(norm(joint - Vec3d{1, 2, 4.5}), 0, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Levels, FixedBase,
                         testing::Values("kinematic_walking", "simplified_dynamics", "full_dynamics",
                                         "articulated_dynamics"));

/// theta'' = -m g l / (I + m l^2) sin theta, by fine steps of Runge-Kutta.
double swung(double angle, double seconds) {
  const double rate2 = mass * 9.81 * arm / (inertia + mass * arm * arm);
  double q = angle, v = 0;
  const double h = 1e-4;
  for (int i = 0; i < static_cast<int>(std::lround(seconds / h)); ++i) {
    const auto a = [&](double x) { return -rate2 * std::sin(x); };
    const double k1 = v, l1 = a(q), k2 = v + 0.5 * h * l1, l2 = a(q + 0.5 * h * k1);
    const double k3 = v + 0.5 * h * l2, l3 = a(q + 0.5 * h * k2), k4 = v + h * l3, l4 = a(q + h * k3);
    q += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    v += h / 6 * (l1 + 2 * l2 + 2 * l3 + l4);
  }
  return q;
}

TEST(FixedBasePendulum, SwingsAsAPendulumDoes) {
  Bolted bolted("articulated_dynamics", false);
  bolted.robot->object("j").set(properties::joint_position, 1.2);
  for (int ms = 1; ms <= 1000; ++ms) {
    bolted.rig.simulation.step();
    if (ms % 250 != 0) continue;
    EXPECT_NEAR(bolted.joint(properties::joint_position), swung(1.2, 1e-3 * ms), 6e-3) << "after " << ms << " ms";
  }
}

}  // namespace
}  // namespace murosimf::dynamics
