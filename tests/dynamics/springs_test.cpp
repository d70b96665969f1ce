// Springs in joints against the closed forms of oscillators.
#include <gtest/gtest.h>

#include "murosimf/dynamics/motion_properties.h"
#include "tests/fixtures.h"
#include "tests/law.h"
#include "tests/physics/bolted.h"

namespace murosimf::test {
namespace {

using dynamics::Integrator;

constexpr const char* level = "articulated_dynamics";
constexpr double m = 0.8, k = 200, slack = 0.15;  // [kg], [N/m], [m]

/// A mass on a rail with a spring, across gravity or along it.
Chain mass_on_spring(const Vec3d& rail, double stiffness = k, double damping = 0) {
  return Chain{}
      .base("wall")
      .prismatic("joint", rail)
      .with(properties::mass, m)
      .with(properties::joint_stiffness, stiffness)
      .with(properties::joint_spring_reference, slack)
      .with(properties::joint_damping, damping);
}

struct Swing {
  double period = 0;           // [s] of all full swings
  double first = 0, last = 0;  // [m] largest deflection of the first and the last swing
};

/// Deflection [m] from the slack place in every step, for `seconds`.
std::vector<double> deflections(Bolted& robot, double start, double seconds) {
  auto joint = robot.joint("joint");
  joint.set(properties::joint_position, slack + start);
  joint.set(properties::joint_velocity, 0);
  std::vector<double> x{start};
  for (int i = 0; i < std::lround(1000 * seconds); ++i) {
    robot.rig.simulation.step();
    x.push_back(joint.get(properties::joint_position) - slack);
  }
  return x;
}

Swing swing(const std::vector<double>& x) {
  std::vector<double> crossings, largest{0};
  for (std::size_t i = 1; i < x.size(); ++i) {
    if (x[i] * x[i - 1] < 0) {
      crossings.push_back(1e-3 * (static_cast<double>(i) - x[i] / (x[i] - x[i - 1])));
      largest.push_back(0);
    }
    largest.back() = std::max(largest.back(), std::abs(x[i]));
  }
  const double period = 2 * (crossings.back() - crossings.front()) / static_cast<double>(crossings.size() - 1);
  return {period, largest[1], largest[largest.size() - 2]};
}

class SpringByIntegrator : public testing::TestWithParam<Integrator> {};

// Average acceleration: slower by (h w)^2 / 12 = 2e-5 at 1 ms; samples miss the largest deflection by (h w)^2 / 8 at most.
TEST_P(SpringByIntegrator, SwingsWithThePeriodOfItsClosedFormAndLosesNothing) {
  Bolted robot(mass_on_spring({1, 0, 0}), GetParam());
  const Swing found = swing(deflections(robot, 0.1, 20));
  const double closed = 2 * pi * std::sqrt(m / k);
  const std::string where = GetParam() == Integrator::rk4 ? "articulated_dynamics, rk4" : level;
  law::expect_near({.law = "0.8 kg on a spring of 200 N/m: period", .level = where, .source = "2 pi sqrt(m / k)"},
                   found.period, closed, 3e-5 * closed, "s");
  law::expect_near({.law = "0.8 kg on a spring of 200 N/m, 50 swings: last deflection over first",
                    .level = where,
                    .source = "no damper: 1"},
                   found.last / found.first, 1, 1e-4, "");
}
INSTANTIATE_TEST_SUITE_P(Springs, SpringByIntegrator, testing::Values(Integrator::semi_implicit_euler, Integrator::rk4),
                         [](const auto& test) { return test.param == Integrator::rk4 ? "rk4" : "euler"; });

// Bent and turned about a hinge: k (q - slack) = m g l cos q.
TEST(Spring, CarriesAWeightAtItsStaticDeflection) {
  Bolted slider(mass_on_spring({0, 0, -1}, k, 20));
  slider.rig.run(3);
  law::expect_near({.law = "0.8 kg hangs on a spring of 200 N/m: deflection", .level = level, .source = "m g / k"},
                   slider.joint("joint").get(properties::joint_position) - slack, m * g / k, 1e-9, "m");
  const double l = 0.3, hinge_k = 6;
  Bolted arm(Chain{}
                 .base("wall")
                 .revolute("joint", {0, 1, 0})
                 .with(properties::mass, m)
                 .with(properties::center_of_mass, {l, 0, 0})
                 .with(properties::joint_stiffness, hinge_k)
                 .with(properties::joint_spring_reference, -0.1)
                 .with(properties::joint_damping, 1));
  arm.rig.run(5);
  const double q = arm.joint("joint").get(properties::joint_position);
  law::expect_near({.law = "arm on a torsion spring: spring torque minus moment of the weight",
                    .level = level,
                    .source = "k (q - slack) = m g l cos q"},
                   hinge_k * (q + 0.1) - m * g * l * std::cos(q), 0, 1e-9, "N m");
}

// x(t) of a damped oscillator; error of first order, h w / 2 of the amplitude.
TEST(Spring, WithDamperFollowsTheDampedOscillator) {
  const double damping = 4, decay = damping / (2 * m), w = std::sqrt(k / m - decay * decay);
  Bolted robot(mass_on_spring({1, 0, 0}, k, damping));
  const auto x = deflections(robot, 0.1, 2);
  law::Worst error;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double t = 1e-3 * static_cast<double>(i);
    const double closed = 0.1 * std::exp(-decay * t) * (std::cos(w * t) + decay / w * std::sin(w * t));
    error.see(std::abs(x[i] - closed), "time", t);
  }
  law::expect_below({.law = "0.8 kg on a spring of 200 N/m with a damper of 4 N s/m: error of the way",
                     .level = level,
                     .source = "damped oscillator"},
                    error, 1e-3, "m");
}

// h w = 5: an explicit spring would grow 20-fold in every step. Bound: the discrete oscillation that starts at rest.
TEST(Spring, TooStiffForTheStepStaysBounded) {
  const double hw = 5;
  Bolted robot(mass_on_spring({1, 0, 0}, m * hw * hw * 1e6));
  const auto x = deflections(robot, 0.01, 5);
  const double mu = hw * hw / (1 + hw * hw / 4), along = 1 - mu / 2, across = std::sqrt(1 - along * along);
  const double largest = *std::max_element(x.begin(), x.end());
  EXPECT_LE(largest, 0.01 * std::hypot(1, mu / 2 / across) * (1 + 1e-6));
}

/// Torque [N m] that a motion takes of a joint with this spring and damper, step by step.
std::vector<std::pair<double, double>> torques(double stiffness, double damping) {
  Rig rig;
  rig.simulation.world().gravity = {};
  Chain chain = Chain{}
                    .base("base")
                    .with(properties::mass, 2.0)
                    .with(properties::inertia, diagonal(0.05))
                    .revolute("joint", {0, 1, 0})
                    .with(properties::mass, 0.2)
                    .with(properties::center_of_mass, {0, 0, -0.1})
                    .with(properties::inertia, diagonal(1e-3))
                    .with(properties::joint_stiffness, stiffness)
                    .with(properties::joint_spring_reference, slack)
                    .with(properties::joint_damping, damping);
  Entity& robot = rig.add("robot", std::make_shared<const Model>("limb", chain));
  rig.attach_dynamics(robot, {.level = "full_dynamics", .on_ground = false});
  rig.simulation.initialize();
  auto joint = robot.object("joint");
  joint.set(properties::joint_target, 0.7);
  std::vector<std::pair<double, double>> result;
  for (int i = 0; i < 100; ++i) {
    rig.simulation.step();
    const double q = joint.get(properties::joint_position), qd = joint.get(properties::joint_velocity);
    result.emplace_back(joint.get(properties::joint_torque), stiffness * (q - slack) + damping * qd);
  }
  return result;
}

// Rule: where the motion is given, the servo has to give what spring and damper take, and the motion does not change.
TEST(Spring, CountsInTheTorqueThatAGivenMotionTakes) {
  const auto without = torques(0, 0), with = torques(12, 0.3);
  law::Worst error;
  double largest = 0;
  for (std::size_t i = 0; i < with.size(); ++i) {
    error.see(std::abs(with[i].first - without[i].first - with[i].second), "step", i);
    largest = std::max(largest, with[i].second);
  }
  EXPECT_GT(largest, 5);
  law::expect_below({.law = "joint with spring and damper: needed torque beyond that without them",
                     .level = "full_dynamics",
                     .source = "k (q - slack) + d qd"},
                    error, 1e-12, "N m");
}

TEST(Spring, ImpossibleOnesAreNamed) {
  for (const double stiffness : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_TRUE(fixtures::says(fixtures::error_of([&] {
                                 Bolted robot(mass_on_spring({1, 0, 0}, stiffness));
                               }),
                               {"robot", "'joint'", "spring"}));
  }
}

}  // namespace
}  // namespace murosimf::test
