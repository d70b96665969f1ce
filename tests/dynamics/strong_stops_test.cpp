// Ends of a joint's range under servos and limbs of every strength: how far they give way, and that they come to rest.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/dynamics/limb.h"
#include "tests/law.h"

namespace murosimf::dynamics {
namespace {

constexpr double end = 0.6;       // [rad]
constexpr double most = 10e-3;    // [rad] beyond it
constexpr double resting = 1e-6;  // [rad/s]

struct Arrival {
  law::Worst beyond;   // [rad]
  law::Worst rebound;  // [1] rate away from the end over the largest one towards it
  law::Worst last;     // [rad/s] after 3 s
  law::Worst torque;   // [1] of the servo over its limit
};

void arrive(test::Limb& limb, double target, double limit, const std::string& what, Arrival& all) {
  limb.go_to(target);
  double fastest = std::abs(limb.qd()), back = 0, beyond = 0, last = 0, torque = 0;
  bool arrived = false;
  limb.run(3, [&] {
    beyond = std::max(beyond, limb.q() - end);
    torque = std::max(torque, std::abs(limb.torque()));
    arrived |= limb.q() > end - 1e-3;
    (arrived ? back : fastest) = std::max(arrived ? back : fastest, arrived ? -limb.qd() : limb.qd());
  });
  limb.run(0.3, [&] { last = std::max(last, std::abs(limb.qd())); });
  EXPECT_TRUE(arrived) << what;
  all.beyond.see(beyond, what);
  if (fastest > 0) all.rebound.see(back / fastest, what);
  all.last.see(last, what);
  all.torque.see(torque / limit, what);
}

void expect_all(const std::string& what, const Arrival& all) {
  const std::string level = "articulated_dynamics, 0.5 to 10 ms";
  law::expect_below({.law = what + ": farthest beyond the end", .level = level, .source = "the project's own limit"},
                    all.beyond, most, "rad");
  law::expect_below({.law = what + ": rate back from the end over that of arrival",
                     .level = level,
                     .source = "ends win no energy; the project's own limit"},
                    all.rebound, 0.1, "1");
  law::expect_below({.law = what + ": rate after 3 s", .level = level, .source = "it rests"}, all.last, resting,
                    "rad/s");
  law::expect_below({.law = what + ": largest torque over the limit", .level = level, .source = "its limit"},
                    all.torque, 1 + 1e-12, "1");
}

Servo motor(double torque, double no_load) {
  return {.law = "dc_motor", .stall_torque = torque, .no_load_speed = no_load, .position_gain = 5 * torque};
}
Servo ideal(double torque) {
  return {.law = "ideal_pd", .stall_torque = torque, .position_gain = 5 * torque, .velocity_gain = 0.1 * torque};
}

struct Case {
  double dt, torque, rate, inertia, start;
  bool limited;  // by the joint's rate instead of the motor's
};

void drive_beyond(const Case& c, Arrival& all) {
  test::LimbModel model{.servo = c.limited ? ideal(c.torque) : motor(c.torque, c.rate),
                        .inertia = c.inertia,
                        .range = Vec3d{-0.5, end, 0}};
  if (c.limited) model.rate_limit = c.rate;
  test::Limb limb(model, {.steps_per_second = 1 / c.dt});
  limb.place(c.start, c.start < 0 || c.inertia < 0.01 ? 0 : c.rate);
  const double turned_back = c.limited ? 0 : 1;  // [no-load rate] a motor makes more than at stall
  arrive(limb, 2, c.torque * (1 + turned_back),
         fmt::format("{} ms, {} N m, {} rad/s, {} kg m^2, {} from {}", 1e3 * c.dt, c.torque, c.rate, c.inertia,
                     model.servo.law, c.start),
         all);
}

// From afar, and from where the first step takes them over the end.
TEST(StrongStops, HoldServosThatArriveAtFullSpeed) {
  Arrival all;
  for (const double dt : test::servo_steps) {
    for (const double torque : {5.0, 20.0, 200.0}) {
      for (const double rate : {5.0, 10.0, 20.0}) {
        for (const double inertia : {1e-4, 1e-3, 1e-2, 0.1, 1.0, 5.0}) {
          for (const double start : {-0.4, end - 1.3e-3, end - 1e-2}) {
            for (const bool limited : {false, true}) drive_beyond({dt, torque, rate, inertia, start, limited}, all);
          }
        }
      }
    }
  }
  expect_all("servos of 5 to 200 N m drive limbs of 1e-4 to 5 kg m^2 at 5 to 20 rad/s beyond their end", all);
}

// With the servo switched off, which says how firm its gear is.
TEST(StrongStops, HoldHeavyLimbsThatFall) {
  Arrival all;
  for (const double dt : test::servo_steps) {
    for (const double torque : {1.0, 20.0}) {
      for (const double mass : {0.2, 1.0, 20.0}) {
        for (const double arm : {0.1, 0.5}) {
          const test::LimbModel model{.servo = ideal(torque),
                                      .inertia = 0.01 * mass * arm * arm,
                                      .arm = arm,
                                      .mass = mass,
                                      .range = Vec3d{-1.5, end, 0}};
          test::Limb limb(model, {.steps_per_second = 1 / dt});
          limb.place(-1.2, 0);
          limb.entity.object("j").set(properties::torque_enabled, 0);
          arrive(limb, 0, torque, fmt::format("{} ms, {} N m, {} kg at {} m", 1e3 * dt, torque, mass, arm), all);
        }
      }
    }
  }
  expect_all("limbs of 0.2 to 20 kg at 0.1 to 0.5 m fall on their end", all);
}

}  // namespace
}  // namespace murosimf::dynamics
