// Order and invariants of the integrators.
#include <gtest/gtest.h>

#include "murosimf/dynamics/articulated_dynamics.h"
#include "tests/fixtures.h"
#include "tests/law.h"
#include "tests/physics/rig.h"

namespace murosimf::test {
namespace {

using dynamics::Integrator;

const char* name_of(Integrator integrator) {
  for (const auto& entry : dynamics::integrators()) {
    if (entry.integrator == integrator) return entry.name.data();
  }
  return "?";
}

/// Two rods of 0.3 m and 0.2 kg, one behind the other, hinged about y; the first one at the base.
ModelPtr double_pendulum() {
  const auto rod = [](Chain& chain, const char* name) {
    const double m = 0.2, l = 0.3;
    chain.revolute(name, {0, 1, 0})
        .with(properties::mass, m)
        .with(properties::center_of_mass, {0, 0, -0.5 * l})
        .with(properties::inertia, SymMat3d{m * l * l / 12, m * l * l / 12, 1e-5, 0, 0, 0});
  };
  Chain chain = Chain{}.base("base").with(properties::mass, 1.0).with(properties::inertia, {0.1, 0.1, 0.1, 0, 0, 0});
  rod(chain, "upper");
  chain.translation({0, 0, -0.3});
  rod(chain, "lower");
  return std::make_shared<const Model>("double_pendulum", chain);
}

/// Kinetic and potential energy [J] from the columns.
double energy(Entity& entity, const Vec3d& gravity) {
  double sum = 0;
  const Model& model = entity.model();
  const auto &r = entity.find(properties::position)->values, &v = entity.find(properties::linear_velocity)->values,
             &w = entity.find(properties::angular_velocity)->values;
  const auto& R = entity.find(properties::orientation)->values;
  for (const Link& link : model.tree().links) {
    const int i = link.object;
    const Vec3d arm = R[i] * link.com, u = v[i] + cross(w[i], arm);
    sum += 0.5 * link.mass * dot(u, u) + 0.5 * dot(w[i], rotated(R[i], link.inertia) * w[i]) -
           link.mass * dot(gravity, r[i] + arm);
  }
  return sum;
}

struct Pendulum {
  Pendulum(double rate_hz, Integrator integrator) : rig(0.8, 0, rate_hz) {
    entity = &rig.add("pendulum", double_pendulum(), {.position = {0, 0, 2}});
    rig.simulation.attach<dynamics::ArticulatedDynamics>("articulated_dynamics", *entity, rate_hz,
                                                         dynamics::MovingTreeOptions{.integrator = integrator,
                                                                                     .fixed_base = true});
    rig.simulation.initialize();
    entity->object("upper").set(properties::joint_position, 1.5);
    entity->object("lower").set(properties::joint_position, 0.7);
    rig.simulation.step();
  }
  [[nodiscard]] double energy_now() const { return energy(*entity, {0, 0, -g}); }
  Rig rig;
  Entity* entity = nullptr;
};

TEST(RungeKutta, KeepsTheEnergyOfADoublePendulum) {
  Pendulum pendulum(2000, Integrator::rk4);
  const double start = pendulum.energy_now();
  law::Worst drift;
  for (int i = 0; i < 20000; ++i) {
    pendulum.rig.simulation.step();
    if (i % 10 == 0) drift.see(std::abs(pendulum.energy_now() - start), "step", i);
  }
  law::expect_below({.law = "double pendulum, 10 s at 2 kHz: change of the energy",
                     .level = "articulated_dynamics, rk4",
                     .source = "no friction: none"},
                    drift, 1e-8, "J");
}

/// A robot without servos in free flight, with turning base and moving limbs.
struct Flight {
  Flight(const std::string& level, Integrator integrator, double rate_hz) : rig(0.8, 0, rate_hz) {
    rig.simulation.world().gravity = {};
    robot = &rig.add("robot", std::make_shared<const Model>(fixtures::two_legged()), {.position = {0, 0, 1}});
    Dynamics dynamics{.level = level, .law = law_named("kelvin_voigt"), .on_ground = false};
    dynamics.tree.integrator = integrator;
    dynamics.tree.momentum_correction = false;
    rig.attach_dynamics(*robot, dynamics);
    rig.simulation.initialize();
    for (const char* name : {"left_hip_pitch", "right_hip_roll", "right_knee"}) {
      robot->object(name).set(properties::joint_velocity, 2.0);
    }
    robot->base().set(properties::angular_velocity, {1, 2, 0.5});
  }
  Vec3d run(double s) {
    rig.run(s);
    return robot->object("left_foot").get(properties::position);
  }
  Rig rig;
  Entity* robot = nullptr;
};

class Order : public testing::TestWithParam<std::tuple<std::string, Integrator>> {};

// Richardson: three steps, each half of the one before, give the order from the ratio of the differences.
TEST_P(Order, IsThatOfTheMethod) {
  const auto& [level, integrator] = GetParam();
  const bool fourth = integrator == Integrator::rk4;
  const double rate = fourth ? 500 : 2000;
  const double time = 0.1;
  const Vec3d coarse = Flight(level, integrator, rate).run(time),
              middle = Flight(level, integrator, 2 * rate).run(time),
              fine = Flight(level, integrator, 4 * rate).run(time);
  const double order = std::log2(norm(coarse - middle) / norm(middle - fine));
  law::expect_near({.law = "free flight with moving limbs: order of the error of a foot's place",
                    .level = level + ", " + name_of(integrator),
                    .source = fourth ? "Runge-Kutta of fourth order" : "semi-implicit Euler"},
                   order, fourth ? 4 : 1, fourth ? 0.3 : 0.15, "");
}

INSTANTIATE_TEST_SUITE_P(Integrators, Order,
                         testing::Combine(testing::ValuesIn(dynamic_levels()),
                                          testing::Values(Integrator::semi_implicit_euler, Integrator::rk4)),
                         [](const auto& test) {
                           return std::get<0>(test.param) + "_" + name_of(std::get<1>(test.param));
                         });

TEST(RungeKutta, RefusesAnImplicitContactLaw) {
  Rig rig;
  Entity& robot = rig.add("robot", kid21());
  Dynamics dynamics{.level = "articulated_dynamics"};
  dynamics.tree.integrator = Integrator::rk4;
  rig.attach_dynamics(robot, dynamics);
  EXPECT_TRUE(fixtures::says(fixtures::error_of([&] { rig.simulation.initialize(); }),
                             {"articulated_dynamics of robot", "rk4", "explicit contact law"}));
}

}  // namespace
}  // namespace murosimf::test
