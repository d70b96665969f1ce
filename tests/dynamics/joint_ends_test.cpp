// Joints at the ends of their range, at every level that has forces.
#include <gtest/gtest.h>

#include "tests/fixtures.h"
#include "tests/law.h"
#include "tests/physics/bolted.h"

namespace murosimf::test {
namespace {

constexpr const char* level = "articulated_dynamics";
// Way into a stop per rate: (a/b)^(a/(b - a)) / b, with the decays a, b of x'' + 5 ms w^2 x' + w^2 x = 0, w = 800 rad/s.
constexpr double stop_time = 0.273e-3;  // [s]
constexpr double stop_frequency = 800;  // [rad/s]

/// What a joint without servo did on its way to the upper end of its range.
struct Arrival {
  double farthest = 0;     // [rad | m] beyond the end
  double rebound = 0;      // [rad | m] back from the end, after it was reached
  double most_energy = 0;  // [J] ever, more than at the start
  double place = 0, rate = 0;
};

/// Runs for 3 s; energy(q, qd) [J] is zero at the start.
template <class Energy>
Arrival arrive(Bolted& robot, double end, const Energy& energy) {
  auto joint = robot.joint("joint");
  Arrival result;
  bool arrived = false;
  for (int i = 0; i < 3000; ++i) {
    robot.rig.simulation.step();
    result.place = joint.get(properties::joint_position);
    result.rate = joint.get(properties::joint_velocity);
    arrived |= result.place >= end;
    result.farthest = std::max(result.farthest, result.place - end);
    if (arrived) result.rebound = std::max(result.rebound, end - result.place);
    result.most_energy = std::max(result.most_energy, energy(result.place, result.rate));
  }
  return result;
}

void expect_rest(const std::string& what, const Arrival& arrival, double end, double speed, double bend,
                 const std::string& unit) {
  const std::string source = "overdamped stop of 800 rad/s, and its bend";
  law::expect_below({.law = what + ": farthest beyond the end", .level = level, .source = source}, arrival.farthest,
                    1.1 * speed * stop_time + bend, unit);
  law::expect_below({.law = what + ": way back from the end", .level = level, .source = "no bounce"}, arrival.rebound,
                    1e-12, unit);
  law::expect_near({.law = what + ": where it rests", .level = level, .source = "end of the range, bent by the weight"},
                   arrival.place, end + bend, 1e-6, unit);
  EXPECT_LT(std::abs(arrival.rate), 1e-9);
}

// An arm of 0.5 kg, 0.3 m from its hinge, falls from level. Energy of a semi-implicit step is off by m g dz of half a step.
TEST(JointEnds, ArmWithoutServoFallsToItsEndAndRests) {
  const double m = 0.5, l = 0.3, I = 0.002, end = 0.6, J = I + m * l * l;
  Bolted robot(Chain{}
                   .base("wall")
                   .revolute("joint", {0, 1, 0})
                   .with(properties::mass, m)
                   .with(properties::center_of_mass, {l, 0, 0})
                   .with(properties::inertia, diagonal(I))
                   .with(properties::joint_range, {-0.5, end, 0}));
  const auto energy = [&](double q, double qd) { return 0.5 * J * qd * qd - m * g * l * std::sin(q); };
  const Arrival arrival = arrive(robot, end, energy);
  const double speed = std::sqrt(2 * m * g * l * std::sin(end) / J), k = J * stop_frequency * stop_frequency;
  expect_rest("arm without servo falls on its end", arrival, end, speed, m * g * l * std::cos(end) / k, "rad");
  law::expect_below({.law = "arm without servo falls on its end: energy gained",
                     .level = level,
                     .source = "none; half a step's work of gravity"},
                    arrival.most_energy, 0.5e-3 * m * g * l * speed, "J");
}

// A slider of 0.8 kg falls by 0.2 m.
TEST(JointEnds, SliderWithoutServoFallsToItsEndAndRests) {
  const double m = 0.8, end = 0.2;
  Bolted robot(Chain{}
                   .base("wall")
                   .prismatic("joint", {0, 0, -1})
                   .with(properties::mass, m)
                   .with(properties::joint_range, {-0.1, end, 0}));
  const auto energy = [&](double q, double qd) { return 0.5 * m * qd * qd - m * g * q; };
  const Arrival arrival = arrive(robot, end, energy);
  const double speed = std::sqrt(2 * g * end), k = m * stop_frequency * stop_frequency;
  expect_rest("slider without servo falls on its end", arrival, end, speed, m * g / k, "m");
  law::expect_below({.law = "slider without servo falls on its end: energy gained",
                     .level = level,
                     .source = "none; half a step's work of gravity"},
                    arrival.most_energy, 0.5e-3 * m * g * speed, "J");
}

// A hand behind the joint counts: its stop is as firm as what it moves is heavy. Bounds as above, for the whole arm.
TEST(JointEnds, CarriedLinksDoNotBendTheEnd) {
  const double m = 2, l = 0.5, end = 0.4, J = m * l * l;
  Bolted robot(Chain{}
                   .base("wall")
                   .revolute("joint", {0, 1, 0})
                   .with(properties::mass, 1e-3)
                   .with(properties::inertia, diagonal(1e-6))
                   .with(properties::joint_range, {-0.5, end, 0})
                   .translation({l, 0, 0})
                   .with(properties::mass, m));
  const double speed = std::sqrt(2 * m * g * l * std::sin(end) / J);
  const Arrival arrival = arrive(robot, end, [](double, double) { return 0.0; });
  EXPECT_LT(arrival.farthest,
            1.1 * speed * stop_time + m * g * l * std::cos(end) / (J * stop_frequency * stop_frequency));
  EXPECT_LT(arrival.rebound, 1e-9);
}

/// A body with one limb whose joint cannot stand at zero.
ModelPtr bent_limb(bool servo) {
  Chain chain = Chain{}
                    .base("base")
                    .with(properties::mass, 2.0)
                    .with(properties::inertia, diagonal(0.05))
                    .revolute("joint", {0, 1, 0})
                    .with(properties::mass, 0.2)
                    .with(properties::center_of_mass, {0, 0, -0.1})
                    .with(properties::inertia, diagonal(1e-3))
                    .with(properties::joint_range, {0.3, 0.8, 0});
  if (servo) {
    chain.with(properties::servo, {.law = "ideal_pd", .stall_torque = 3, .position_gain = 5, .velocity_gain = 0.2});
  }
  return std::make_shared<const Model>("bent_limb", chain);
}

struct BentLimb {
  BentLimb(const std::string& its_level, bool servo, dynamics::Integrator integrator = {}) {
    rig.simulation.world().gravity = {};
    robot = &rig.add("robot", bent_limb(servo));
    Dynamics dynamics{.level = its_level, .law = law_named("kelvin_voigt"), .on_ground = false};
    dynamics.tree.integrator = integrator;
    rig.attach_dynamics(*robot, dynamics);
    rig.simulation.initialize();
  }
  double q() { return robot->object("joint").get(properties::joint_position); }
  Rig rig;
  Entity* robot = nullptr;
};

class EndsAtLevel : public testing::TestWithParam<std::string> {};

// Rule: a target of zero means the end next to it, at the start and later; servos bend a stop by up to half a degree.
TEST_P(EndsAtLevel, RangeWithoutZeroHoldsFromTheStart) {
  for (const bool servo : {false, true}) {
    BentLimb limb(GetParam(), servo);
    EXPECT_EQ(limb.q(), 0.3);
    limb.rig.run(0.5);
    EXPECT_NEAR(limb.q(), 0.3, 0.5 * degree);
    limb.robot->object("joint").set(properties::joint_target, 2.0);
    limb.robot->object("joint").set(properties::joint_velocity, 5.0);
    double farthest = 0;
    for (int i = 0; i < 1000; ++i) {
      limb.rig.simulation.step();
      farthest = std::max(farthest, limb.q());
    }
    EXPECT_LT(farthest, 0.8 + 1 * degree);
    EXPECT_GT(farthest, 0.8 - 1e-9);
    if (servo) {
      EXPECT_NEAR(limb.q(), 0.8, 0.5 * degree);
    }
  }
}
INSTANTIATE_TEST_SUITE_P(Dynamic, EndsAtLevel, testing::ValuesIn(dynamic_levels()), level_name);

// Rule: a joint whose motion is given never leaves its range, however fast it comes and whatever the integrator.
TEST(JointEnds, GivenMotionStaysInsideWithRungeKutta) {
  for (const std::string name : {"simplified_dynamics", "full_dynamics"}) {
    BentLimb limb(name, true, dynamics::Integrator::rk4);
    auto joint = limb.robot->object("joint");
    joint.set(properties::joint_target, 0.8);
    joint.set(properties::joint_position, 0.75);
    joint.set(properties::joint_velocity, 30);
    bool arrived = false;
    for (int i = 0; i < 200; ++i) {
      limb.rig.simulation.step();
      EXPECT_LE(limb.q(), 0.8) << name;
      arrived |= limb.q() == 0.8;
    }
    EXPECT_TRUE(arrived) << name;
  }
}

}  // namespace
}  // namespace murosimf::test
