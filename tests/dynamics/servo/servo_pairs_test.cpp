// Twenty pairs of a servo and a limb at steps of 0.5 to 10 ms: what limits the servo holds in every step, whatever hangs on it, and what
// closed forms say of the way; at the end the limb stands at its target.
#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/dynamics/limb.h"
#include "tests/law.h"

namespace murosimf::dynamics {
namespace {

constexpr double target = 0.8;  // [rad]
const std::string level = "articulated_dynamics, 0.5 to 10 ms";

constexpr double friction = 0.02;  // [N m] of joints with play, which would go to and fro in it without end

struct Pair {
  const char* name;
  test::LimbModel limb;
};

Servo ideal(double torque) {
  return {.law = "ideal_pd", .stall_torque = torque, .position_gain = 15 * torque, .velocity_gain = 0.3 * torque};
}
/// Its speed-torque line damps it. Stiff enough to be at its duty limit on the way, soft enough not to swing for long.
Servo motor(double torque, double no_load, double gain = 4) {
  return {.law = "dc_motor", .stall_torque = torque, .no_load_speed = no_load, .position_gain = gain * torque};
}
Servo with_current_limit(Servo servo, double torque) {
  servo.torque_limit = torque;
  return servo;
}
Servo with_play(Servo servo, double backlash) {
  servo.backlash = backlash;
  servo.rotor_inertia = 2e-3;
  servo.friction.viscous = 0.05;
  return servo;
}

/// [kg m^2] 0.3 kg at 0.1 m: the limb of `limit 100 N m`.
constexpr double light = 0.003;

const std::vector<Pair>& pairs() {
  static const std::vector<Pair> all{
      {"5 N m, 1e-5 kg m^2", {.servo = ideal(5), .inertia = 1e-5}},
      {"5 N m, 0.1 kg m^2", {.servo = ideal(5), .inertia = 0.1}},
      {"100 N m, 0.3 kg", {.servo = ideal(100), .inertia = light, .mass = 0.3}},
      {"100 N m, 1e-5 kg m^2", {.servo = ideal(100), .inertia = 1e-5}},
      {"100 N m, 2 kg m^2", {.servo = ideal(100), .inertia = 2}},
      {"motor, 1e-5 kg m^2", {.servo = motor(5, 8), .inertia = 1e-5}},
      {"motor, 3 g m^2", {.servo = motor(5, 8), .inertia = light}},
      {"motor, 0.1 kg m^2", {.servo = motor(5, 8), .inertia = 0.1}},
      {"motor of 100 N m, 1e-4 kg m^2", {.servo = motor(100, 20), .inertia = 1e-4}},
      {"motor with a current limit, 0.1 kg m^2", {.servo = with_current_limit(motor(20, 12), 6), .inertia = 0.1}},
      {"motor with a current limit, 1e-4 kg m^2", {.servo = with_current_limit(motor(20, 12), 6), .inertia = 1e-4}},
      {"2 rad/s, 1e-5 kg m^2", {.servo = ideal(5), .inertia = 1e-5, .rate_limit = 2}},
      {"2 rad/s, 100 N m, 3 g m^2", {.servo = ideal(100), .inertia = light, .rate_limit = 2}},
      {"2 rad/s, 0.1 kg m^2", {.servo = ideal(5), .inertia = 0.1, .rate_limit = 2}},
      {"motor at 3 rad/s, 0.1 kg m^2", {.servo = motor(20, 8), .inertia = 0.1, .rate_limit = 3}},
      {"coupled, 1e-4 kg m^2", {.servo = ideal(5), .inertia = 1e-4, .follows = -1.5}},
      {"coupled, 100 N m, 0.1 kg m^2", {.servo = ideal(100), .inertia = 0.1, .follows = 2}},
      {"coupled at 2 rad/s, 3 g m^2", {.servo = ideal(20), .inertia = light, .rate_limit = 2, .follows = -1}},
      {"play, 3 g m^2", {.servo = with_play(ideal(5), 0.02), .inertia = light, .friction = friction}},
      {"play, motor, 0.1 kg m^2", {.servo = with_play(motor(5, 8), 0.02), .inertia = 0.1, .friction = friction}},
  };
  return all;
}

/// Visits each pair at each step.
template <class Visit>
void for_all(const Visit& visit) {
  for (const Pair& pair : pairs()) {
    for (const double dt : test::servo_steps) {
      test::Limb limb(pair.limb, {.steps_per_second = 1 / dt});
      limb.go_to(target);
      visit(pair.limb, limb, fmt::format("{}, {} ms", pair.name, 1e3 * dt));
    }
  }
}

TEST(ServoPairs, AreTwenty) { EXPECT_EQ(pairs().size(), 20U); }

// Gear friction is no torque of the motor: the joint's torque may be larger by it.
TEST(ServoPairs, KeepTheirLimits) {
  law::Worst torque, line, rate, coupled;
  for_all([&](const test::LimbModel& model, test::Limb& limb, const std::string& what) {
    const Servo& servo = model.servo;
    const double most = servo.torque_limit > 0 ? servo.torque_limit : servo.stall_torque;
    limb.run(1, [&] {
      const double qd = limb.qd(), made = limb.motor_torque();
      const bool by_rate = servo.no_load_speed > 0 && servo.torque_limit == 0;
      if (!by_rate) torque.see(std::abs(made) / most, what);
      if (by_rate && servo.backlash == 0)
        line.see(std::abs(made / servo.stall_torque + qd / servo.no_load_speed), what);
      if (model.rate_limit) (model.follows ? coupled : rate).see(std::abs(qd) / *model.rate_limit, what);
    });
  });
  law::expect_below({.law = "20 servo-limb pairs: largest torque over its limit", .level = level, .source = "limit"},
                    torque, 1 + 1e-12, "1");
  law::expect_below(
      {.law = "20 servo-limb pairs: torque over stall torque, and rate over no-load rate, of those with a motor",
       .level = level,
       .source = "speed-torque line: their sum is -1 to 1"},
      line, 1 + 1e-12, "1");
  law::expect_below({.law = "20 servo-limb pairs: largest rate over its limit", .level = level, .source = "limit"},
                    rate, 1 + 1e-9, "1");
}

TEST(ServoPairs, StandAtTheirTargets) {
  law::Worst off, rate, gap;
  for_all([&](const test::LimbModel& model, test::Limb& limb, const std::string& what) {
    limb.rig.run(6);
    off.see(std::abs(limb.q() - target) - model.friction / model.servo.position_gain, what);
    rate.see(std::abs(limb.qd()), what);
    if (model.follows) gap.see(std::abs(limb.q("k") - *model.follows * limb.q()), what);
  });
  law::expect_below({.law = "20 servo-limb pairs: distance from the target after 6 s, less what friction holds",
                     .level = level,
                     .source = "nothing loads them; friction over gain"},
                    off, 1e-6, "rad");
  law::expect_below({.law = "20 servo-limb pairs: rate after 6 s", .level = level, .source = "they rest"}, rate, 1e-6,
                    "rad/s");
  law::expect_below({.law = "20 servo-limb pairs: gap of those that are coupled", .level = level, .source = "ratio"},
                    gap, 1e-9, "rad");
}

}  // namespace
}  // namespace murosimf::dynamics
