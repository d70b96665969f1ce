// Limits of a servo's torque hold in every step, whatever hangs on the joint: the joint's inertia decides whether the limit or the
// controller is at work at the end of the step.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/dynamics/limb.h"

namespace murosimf::dynamics {
namespace {

using test::Limb;

TEST(TorqueLimit, HoldsAndALightLimbComesToRest) {
  for (const double limit : {5.0, 20.0, 100.0}) {
    const Servo servo{.law = "ideal_pd",
                      .stall_torque = limit,
                      .position_gain = 15 * limit,
                      .velocity_gain = 0.15 * limit};
    for (const double inertia : {1e-5, 3e-4, 2e-3, 0.02, 0.1}) {
      for (const double steps_per_second : {100.0, 125.0, 200.0, 500.0, 1000.0, 2000.0}) {
        Limb limb({.servo = servo, .inertia = inertia}, {.steps_per_second = steps_per_second});
        limb.go_to(0.3);
        double largest = 0;
        for (int i = 0; i < 3 * steps_per_second; ++i) {
          limb.rig.simulation.step();
          largest = std::max(largest, std::abs(limb.torque()));
        }
        EXPECT_LE(largest, limit * (1 + 1e-12)) << limit << ' ' << inertia << ' ' << steps_per_second;
        EXPECT_NEAR(limb.q(), 0.3, 1e-3) << limit << ' ' << inertia << ' ' << steps_per_second;
        EXPECT_NEAR(limb.qd(), 0, 1e-3) << limit << ' ' << inertia << ' ' << steps_per_second;
      }
    }
  }
}

// T t / I, as long as the controller asks for more.
TEST(TorqueLimit, IsWhatAcceleratesAHeavyLimb) {
  const Servo pd{.law = "ideal_pd", .stall_torque = 5, .position_gain = 1500};
  const Servo motor{
      .law = "dc_motor", .stall_torque = 50, .no_load_speed = 100, .position_gain = 1500, .torque_limit = 5};
  for (const Servo& servo : {pd, motor}) {
    for (const double steps_per_second : {100.0, 125.0, 500.0, 2000.0}) {
      Limb limb({.servo = servo, .inertia = 1}, {.steps_per_second = steps_per_second});
      limb.go_to(1.5);
      limb.rig.run(0.2);
      EXPECT_NEAR(limb.qd(), 5 * 0.2 / 1, 1e-12) << servo.law << ' ' << steps_per_second;
    }
  }
}

// Gravity below the limit is held, and no more torque is made than that takes; beyond the limit, the limb sinks against the limit.
TEST(TorqueLimit, IsWhatALoadHasAgainstIt) {
  const Servo servo{.law = "ideal_pd", .stall_torque = 5, .position_gain = 500, .velocity_gain = 5};
  for (const double steps_per_second : {100.0, 1000.0}) {
    for (const double load : {3.0, 7.0}) {
      Limb limb({.servo = servo, .arm = load / 9.81}, {.steps_per_second = steps_per_second});
      limb.go_to(0);
      limb.rig.run(load < 5 ? 1 : 0.2);
      if (load < 5) {
        EXPECT_NEAR(limb.q(), load / 500, 1e-4);
        EXPECT_NEAR(limb.torque(), -load, 1e-3);
      } else {
        EXPECT_NEAR(limb.torque(), -5, 1e-12);
        EXPECT_GT(limb.q(), 0.02);
      }
    }
  }
}

}  // namespace
}  // namespace murosimf::dynamics
