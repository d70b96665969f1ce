// Kernels of servos: the friction budget of one joint, and a step of the pendulum bench, one at a time and eight in lanes.
#include <benchmark/benchmark.h>

#include <array>

#include "murosimf/math/pack.h"
#include "murosimf/multibody/servo/gear_friction.h"
#include "murosimf/multibody/servo/servo_pendulum.h"

namespace murosimf::benchmarks {
namespace {

const GearFriction m1{.coulomb = 0.012, .viscous = 0.004};
const GearFriction m3{.coulomb = 0.01, .viscous = 0.004, .motor_load = 0.2, .external_load = 0.2};
const GearFriction m4{.coulomb = 0.01,
                      .viscous = 0.004,
                      .stribeck = 0.005,
                      .stribeck_rate = 0.3,
                      .stribeck_exponent = 1.7,
                      .motor_load = 0.25,
                      .external_load = 0.25,
                      .stribeck_motor_load = 0.1,
                      .stribeck_external_load = 0.1};

const GearFriction m6{.coulomb = 6e-7,  // of an MX-64 (Duclusaud et al., ICRA 2025; github.com/Rhoban/bam)
                      .viscous = 0.02534,
                      .stribeck = 0.1227,
                      .stribeck_rate = 2.575,
                      .stribeck_exponent = 0.841,
                      .motor_load = 0.3115,
                      .external_load = 2e-8,
                      .stribeck_motor_load = 0.1877,
                      .stribeck_external_load = 0.0141,
                      .quadratic_motor_load = 0.00691,
                      .quadratic_external_load = 0.0100};

template <class S>
void count_per_joint(benchmark::State& bench, int calls) {
  using benchmark::Counter;
  const double joints = sizeof(S) / sizeof(double) * calls;
  bench.counters["per_joint"] = Counter(joints, Counter::kIsIterationInvariantRate | Counter::kInvert);
}

/// The 20 joints of a robot, each with another rate.
template <class S>
void friction(benchmark::State& bench, const GearFriction& model) {
  std::array<S, 20> rates, motor, external, budget{};
  for (std::size_t i = 0; i < rates.size(); ++i) {
    rates[i] = S(0.1 * static_cast<double>(i) - 0.55);
    motor[i] = S(0.3), external[i] = S(-0.2);
  }
  for (auto _ : bench) {
    for (std::size_t i = 0; i < rates.size(); ++i) {
      budget[i] = multibody::dry_friction(model, rates[i], motor[i], external[i]);
    }
    benchmark::DoNotOptimize(budget);
  }
  count_per_joint<S>(bench, 20);
}

/// The same for joints one by one, with the Stribeck shares of all in lanes before, as in a step of a robot.
void friction_shares_in_lanes(benchmark::State& bench, const GearFriction& model) {
  std::array<double, 20> rates, shares{}, budget{};
  for (std::size_t i = 0; i < rates.size(); ++i) rates[i] = 0.1 * static_cast<double>(i) - 0.55;
  for (auto _ : bench) {
    benchmark::DoNotOptimize(rates);
    multibody::StribeckShares lanes;
    for (std::size_t i = 0; i < rates.size(); ++i) lanes.add(model, rates[i], shares[i]);
    lanes.write();
    for (std::size_t i = 0; i < rates.size(); ++i) {
      budget[i] = multibody::dry_friction_with_share(model, shares[i], 0.3, -0.2);
    }
    benchmark::DoNotOptimize(budget);
  }
  count_per_joint<double>(bench, 20);
}

template <class S>
void pendulum_step(benchmark::State& bench, const GearFriction& model) {
  const multibody::BenchServo servo{.torque_constant = 0.366,
                                    .resistance = 3.3,
                                    .rotor_inertia = 0.0018,
                                    .friction = model};
  const multibody::Bench<S> pendulum{.inertia = S(0.0049), .weight = S(0.48), .gain = S(1.15)};
  multibody::BenchState<S> state{};
  double goal = 1;
  for (auto _ : bench) {
    goal = -goal;
    for (int i = 0; i < 100; ++i) {
      multibody::advance<S>(servo, pendulum, {S(goal), S(7.3), S(1.0)}, 1e-3, state);
    }
    benchmark::DoNotOptimize(state);
  }
  count_per_joint<S>(bench, 100);
}

void friction_one(benchmark::State& bench, const GearFriction& model) { friction<double>(bench, model); }
void friction_lanes(benchmark::State& bench, const GearFriction& model) { friction<Pack8>(bench, model); }
void pendulum_step_one(benchmark::State& bench, const GearFriction& model) { pendulum_step<double>(bench, model); }
void pendulum_step_lanes(benchmark::State& bench, const GearFriction& model) { pendulum_step<Pack8>(bench, model); }

BENCHMARK_CAPTURE(friction_one, m1, m1);
BENCHMARK_CAPTURE(friction_one, m3, m3);
BENCHMARK_CAPTURE(friction_one, m4, m4);
BENCHMARK_CAPTURE(friction_one, m6, m6);
BENCHMARK_CAPTURE(friction_shares_in_lanes, m6, m6);
BENCHMARK_CAPTURE(friction_lanes, m1, m1);
BENCHMARK_CAPTURE(friction_lanes, m3, m3);
BENCHMARK_CAPTURE(friction_lanes, m4, m4);
BENCHMARK_CAPTURE(pendulum_step_one, m1, m1);
BENCHMARK_CAPTURE(pendulum_step_one, m3, m3);
BENCHMARK_CAPTURE(pendulum_step_one, m4, m4);
BENCHMARK_CAPTURE(pendulum_step_lanes, m1, m1);
BENCHMARK_CAPTURE(pendulum_step_lanes, m3, m3);
BENCHMARK_CAPTURE(pendulum_step_lanes, m4, m4);

}  // namespace
}  // namespace murosimf::benchmarks
