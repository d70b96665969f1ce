#include "murosimf/multibody/servo/servo_pendulum.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "murosimf/math/pack.h"
#include "tests/fixtures.h"
#include "tests/law.h"

namespace murosimf::multibody {
namespace {

using fixtures::Dice;
using fixtures::same_bits;

constexpr double ms = 1e-3;

/// The pendulum of the recorded logs at firmware gain 400, without friction.
const BenchServo motor{.torque_constant = 0.366, .resistance = 2.811, .rotor_inertia = 0.0018};
const Bench<double> bench{.inertia = 0.0049, .weight = 0.4805, .gain = 1.151};
const BenchInput<double> off{.goal = 0, .voltage = 7.4, .enabled = 0};

BenchServo with(const GearFriction& friction) {
  BenchServo servo = motor;
  servo.friction = friction;
  return servo;
}

struct Named {
  const char* name;
  GearFriction friction;
};

/// One set of numbers per friction model, of the size of an XL-330's.
std::array<Named, 6> models() {
  GearFriction m1{.coulomb = 0.012, .viscous = 0.004};
  GearFriction m2 = m1;
  m2.stribeck = 0.01, m2.stribeck_rate = 2, m2.stribeck_exponent = 1;
  GearFriction m3 = m1;
  m3.motor_load = m3.external_load = 0.1;
  GearFriction m4 = m2;
  m4.motor_load = m4.external_load = 0.07, m4.stribeck_motor_load = m4.stribeck_external_load = 0.07;
  GearFriction m5 = m4;
  m5.motor_load = 0.25, m5.external_load = 0.01, m5.stribeck_external_load = 0.08;
  GearFriction m6 = m5;
  m6.quadratic_motor_load = 0.01, m6.quadratic_external_load = 0.005;
  return {{{"M1", m1}, {"M2", m2}, {"M3", m3}, {"M4", m4}, {"M5", m5}, {"M6", m6}}};
}

// Law: friction holds a load exactly. The servo lifts the pendulum to where it sticks; there it stays for 60 s, with a
// constant goal and voltage, at every friction model. Tolerance: the demand, 1e-9 rad; it is exact.
TEST(ServoPendulum, AStuckLoadStaysWhereItIs) {
  for (const auto& [name, friction] : models()) {
    BenchState<double> state;
    const BenchInput<double> hold{.goal = 1.0, .voltage = 7.4, .enabled = 1};
    for (int i = 0; i < 5000; ++i) advance(with(friction), bench, hold, ms, state);
    const double stuck = state.position;
    EXPECT_GT(stuck, 0.2) << "it holds a load";
    EXPECT_EQ(state.rate, 0);
    double moved = 0;
    for (int i = 0; i < 60000; ++i) {
      advance(with(friction), bench, hold, ms, state);
      moved = std::fmax(moved, std::fabs(state.position - stuck));
    }
    law::expect_below({"a loaded joint that sticks: how far it moves in 60 s", std::string("friction ") + name,
                       "friction takes what stops it"},
                      moved, 1e-9, "rad");
  }
}

// Law: with a constant friction F alone a turning rotor stops after J w^2/(2 F). Tolerance: a step's way, w h.
TEST(ServoPendulum, CoulombFrictionStopsAfterTheClosedFormsAngle) {
  const double J = bench.inertia + motor.rotor_inertia, w = 5, F = 0.02;
  BenchState<double> state{.position = 0, .rate = w};
  Bench<double> weightless = bench;
  weightless.weight = 0;
  for (int i = 0; i < 3000; ++i) advance(with({.coulomb = F}), weightless, off, ms, state);
  EXPECT_EQ(state.rate, 0);
  EXPECT_NEAR(state.position, J * w * w / (2 * F), w * ms);
}

// Law: with viscous friction alone the rate decays as exp(-K_v t/J). Tolerance: implicit Euler at h = 10 us, whose error
// after one time constant is h K_v/(2 J) of the rate.
TEST(ServoPendulum, ViscousFrictionDecaysExponentially) {
  const double J = bench.inertia + motor.rotor_inertia, K = 0.02, h = 1e-5, t = J / K;
  BenchState<double> state{.position = 0, .rate = 3};
  Bench<double> weightless = bench;
  weightless.weight = 0;
  const int steps = static_cast<int>(t / h);
  for (int i = 0; i < steps; ++i) advance(with({.viscous = K}), weightless, off, h, state);
  EXPECT_NEAR(state.rate, 3 * std::exp(-steps * h / t), 3 * h / t);
}

// Law: at full duty a free servo reaches V/k_t, without friction. Tolerance: rounding; a fixed point has no step error.
TEST(ServoPendulum, ReachesTheNoLoadRate) {
  Bench<double> weightless = bench;
  weightless.weight = 0;
  BenchState<double> state;
  for (int i = 0; i < 10000; ++i) advance(motor, weightless, {.goal = 1e6, .voltage = 7.4, .enabled = 1}, ms, state);
  EXPECT_NEAR(state.rate, 7.4 / motor.torque_constant, 1e-9);
}

// Law: the servo holds weight up to its stall torque k_t V/R and not more: at rest on a level arm.
TEST(ServoPendulum, HoldsItsStallTorqueAndNotMore) {
  const double stall = motor.torque_constant * 7.4 / motor.resistance;
  for (const double share : {0.99, 1.01}) {
    BenchState<double> state{.position = pi / 2, .rate = 0};
    Bench<double> heavy = bench;
    heavy.weight = share * stall;
    for (int i = 0; i < 20; ++i) advance(motor, heavy, {.goal = 1e6, .voltage = 7.4, .enabled = 1}, ms, state);
    EXPECT_EQ(state.rate > 0, share < 1) << share;
  }
}

// Law: a current limit I allows the torque k_t I at any rate below (V - R I)/k_t. Tolerance: rounding.
TEST(ServoPendulum, TheCurrentLimitIsATorqueLimit) {
  BenchServo limited = motor;
  limited.current_limit = 0.5;
  Bench<double> weightless = bench;
  weightless.weight = 0;
  weightless.inertia = 1e3;  // the rate stays where it is
  for (const double rate : {0.0, 5.0, -5.0}) {
    BenchState<double> state{.position = 0, .rate = rate};
    advance(limited, weightless, {.goal = 1e6, .voltage = 7.4, .enabled = 1}, ms, state);
    const double torque = (state.rate - rate) / ms * (weightless.inertia + motor.rotor_inertia);
    EXPECT_NEAR(torque, motor.torque_constant * 0.5, 1e-6) << rate;
  }
}

// Law: an open bridge brakes nothing; a swing without friction keeps its energy. Tolerance: semi-implicit Euler's energy
// oscillates by h/2 times the power, m g l w h/2 < 0.0014 J here, and does not drift.
TEST(ServoPendulum, AnOpenBridgeKeepsTheEnergy) {
  const double J = bench.inertia + motor.rotor_inertia;
  BenchState<double> state{.position = 1.2, .rate = 0};
  const auto energy = [&] { return J * state.rate * state.rate / 2 + bench.weight * (1 - std::cos(state.position)); };
  const double start = energy();
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    advance(motor, bench, off, ms, state);
    worst = std::fmax(worst, std::fabs(energy() - start));
  }
  EXPECT_LT(worst, bench.weight * std::sqrt(2 * start / J) * ms / 2);
}

// Law: friction only takes energy away, at every model. Tolerance: that of the test above.
TEST(ServoPendulum, FrictionTakesEnergyOnly) {
  const double J = bench.inertia + motor.rotor_inertia;
  for (const auto& [name, friction] : models()) {
    BenchState<double> state{.position = 1.2, .rate = 0};
    const double start = bench.weight * (1 - std::cos(1.2));
    for (int i = 0; i < 20000; ++i) advance(with(friction), bench, off, ms, state);
    const double end = J * state.rate * state.rate / 2 + bench.weight * (1 - std::cos(state.position));
    EXPECT_EQ(state.rate, 0) << name;
    EXPECT_LT(end, 0.2 * start) << name;
  }
}

// Law: where encoder zero is not where the pendulum hangs, it comes to rest at -q_0. Tolerance: friction's dead band.
TEST(ServoPendulum, HangsWhereTheOffsetSays) {
  BenchServo servo = with({.viscous = 0.05});
  servo.encoder_offset = 0.03;
  BenchState<double> state{.position = 0.5, .rate = 0};
  for (int i = 0; i < 20000; ++i) advance(servo, bench, off, ms, state);
  EXPECT_NEAR(state.position, -0.03, 1e-9);
}

// Law: D w+ = p, one step of 10 ms; D has the gain while no limit holds the duty, and nothing of the motor while its bridge
// is open. The goal is 0.3 rad away, and 3 rad: there 1.151/rad * 3 rad is above the duty of 1.
TEST(ServoPendulum, OneStepIsLinearlyImplicit) {
  const double J = bench.inertia + motor.rotor_inertia, h = 0.01, V = 6.5, w = 1.7, q = 0.4, K = 0.004;
  const double per_volt = motor.torque_constant / motor.resistance, brake = per_volt * motor.torque_constant;
  const double external = -bench.weight * std::sin(q);
  const auto rate_after = [&](double ahead, double enabled) {
    BenchState<double> state{.position = q, .rate = w};
    advance(with({.viscous = K}), bench, {.goal = q + ahead, .voltage = V, .enabled = enabled}, h, state);
    EXPECT_NEAR(state.position, q + h * state.rate, 1e-15);
    return state.rate;
  };
  const double held = J + h * (brake + K);
  EXPECT_NEAR(rate_after(0.3, 1),
              (J * w + h * (per_volt * bench.gain * 0.3 * V + external)) / (held + h * h * per_volt * V * bench.gain),
              1e-12);
  EXPECT_NEAR(rate_after(3, 1), (J * w + h * (per_volt * V + external)) / held, 1e-12);
  EXPECT_NEAR(rate_after(0.3, 0), (J * w + h * external) / (J + h * K), 1e-12);
}

/// Where the full model is after 0.2 s of pulling up.
double after(double h) {
  BenchState<double> state;
  const int steps = static_cast<int>(std::lround(0.2 / h));
  for (int i = 0; i < steps; ++i) {
    advance(with(models()[5].friction), bench, {.goal = 1.0, .voltage = 7.4, .enabled = 1}, h, state);
  }
  return state.position;
}

// Law: first order. Halving the step halves the error. Tolerance: 15 % of the factor, for terms of second order.
TEST(ServoPendulum, ConvergesWithTheFirstOrderOfTheStep) {
  const double exact = after(1e-6);
  const double ratio = (after(4e-4) - exact) / (after(2e-4) - exact);
  EXPECT_NEAR(ratio, 2, 0.3);
}

// Rule: a lane has the bits of the scalar: different loads, gains, voltages and switches. No tolerance.
TEST(ServoPendulum, LanesAreScalars) {
  Dice dice("servo pendulum");
  for (const auto& [name, friction] : models()) {
    BenchServo servo = with(friction);
    servo.current_limit = dice.chance(0.5) ? 0.8 : 0;
    servo.encoder_offset = 0.02;
    std::array<Bench<double>, 8> benches;
    std::array<BenchState<double>, 8> states{};
    Bench<Pack8> packed;
    BenchState<Pack8> state{};
    for (int i = 0; i < 8; ++i) {
      auto& one = benches[static_cast<std::size_t>(i)];
      one = {dice.uniform(0.002, 0.01), dice.uniform(0.1, 1), dice.uniform(0.2, 3)};
      packed.inertia.set_lane(i, one.inertia), packed.weight.set_lane(i, one.weight), packed.gain.set_lane(i, one.gain);
    }
    for (int step = 0; step < 2000; ++step) {
      BenchInput<Pack8> inputs;
      for (int i = 0; i < 8; ++i) {
        const BenchInput<double> input{1.5 * std::sin(0.003 * step + i), 7 + 0.1 * i, (step / 300 + i) % 3 ? 1.0 : 0.0};
        inputs.goal.set_lane(i, input.goal), inputs.voltage.set_lane(i, input.voltage);
        inputs.enabled.set_lane(i, input.enabled);
        advance(servo, benches[static_cast<std::size_t>(i)], input, ms, states[static_cast<std::size_t>(i)]);
      }
      advance(servo, packed, inputs, ms, state);
      for (int i = 0; i < 8; ++i) {
        ASSERT_TRUE(same_bits(state.position.lane(i), states[static_cast<std::size_t>(i)].position)) << name;
        ASSERT_TRUE(same_bits(state.rate.lane(i), states[static_cast<std::size_t>(i)].rate)) << name;
      }
    }
  }
}

}  // namespace
}  // namespace murosimf::multibody
