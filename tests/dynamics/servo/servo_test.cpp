// Servos that move a joint: the linear second-order system, the speed-torque line, the ends of the range.
#include <gtest/gtest.h>

#include "tests/law.h"
#include "tests/physics/rig.h"

namespace murosimf::test {
namespace {

/// A servo that moves an arm with this inertia [kg m^2] on a bolted base, without gravity.
struct Arm {
  Arm(const Servo& servo, double inertia) {
    rig.simulation.world().gravity = {};
    const auto model = std::make_shared<const Model>("arm", Chain{}
                                                                .base("wall")
                                                                .revolute("hinge", {0, 1, 0})
                                                                .with(properties::servo, servo)
                                                                .with(properties::mass, 1.0)
                                                                .with(properties::inertia, diagonal(inertia)));
    robot = &rig.add("arm", model);
    rig.attach_dynamics(*robot, {.level = "articulated_dynamics", .on_ground = false, .tree = {.fixed_base = true}});
    rig.simulation.initialize();
  }
  ObjectAccess hinge() { return robot->object("hinge"); }

  Rig rig;
  Entity* robot;
};

/// Without friction, so that everything is linear.
Servo motor() {
  return {.type = "test", .stall_torque = 6, .no_load_speed = 6.6, .position_gain = 30, .rotor_inertia = 0.01};
}

// J q'' = kp (target - q) - d q' with J = 0.3 kg m^2 behind the joint, rotor included, and kp = 15 N m/rad. Implicit
// Euler with steps of h adds kp h / 2 to d: 0.8 % of the motor's 0.91 N m s/rad, and with it up to 1 % of the step to the
// response. A stiffer servo is off by more (kp = 30: 1.2 %).
TEST(Servo, StepResponseIsThatOfALinearSystem) {
  constexpr double kp = 15, J = 0.3;
  Servo dc = motor();
  dc.position_gain = kp;
  Servo ideal = dc;
  ideal.law = "ideal_pd";
  ideal.velocity_gain = 3;
  for (const auto& [servo, damping] : {std::pair{ideal, 3.0}, std::pair{dc, dc.stall_torque / dc.no_load_speed}}) {
    Arm arm(servo, J - servo.rotor_inertia);
    const double step = 0.1, w = std::sqrt(kp / J), z = damping / (2 * J * w), wd = w * std::sqrt(1 - z * z);
    arm.hinge().set(properties::joint_target, step);
    law::Worst error;
    for (int i = 1; i <= 1000; ++i) {
      arm.rig.simulation.step();
      const double t = 1e-3 * i;
      const double closed = 1 - std::exp(-z * w * t) * (std::cos(wd * t) + z * w / wd * std::sin(wd * t));
      error.see(std::abs(arm.hinge().get(properties::joint_position) / step - closed), "time", t);
    }
    law::expect_below({.law = "step response of a servo and its arm: error, as a part of the step",
                       .level = "articulated_dynamics, " + servo.law,
                       .source = "closed form of the damped oscillator"},
                      error, 0.01, "");
  }
}

// J qd' = kv (rate - qd): without position gain a servo follows joint_velocity_target. Implicit Euler at 1 ms lags by half a
// step of the time constant J / kv = 60 ms.
TEST(Servo, WithoutPositionGainFollowsARate) {
  const Servo servo{.type = "wheel", .law = "ideal_pd", .velocity_gain = 0.5};
  Arm arm(servo, 0.03);
  arm.hinge().set(properties::joint_velocity_target, 30);
  law::Worst error;
  for (int i = 1; i <= 1000; ++i) {
    arm.rig.simulation.step();
    error.see(std::abs(arm.hinge().get(properties::joint_velocity) / 30 - (1 - std::exp(-1e-3 * i / 0.06))), "time",
              1e-3 * i);
    EXPECT_LE(std::abs(arm.hinge().get(properties::joint_position)), pi) << "whole turns are taken out";
  }
  law::expect_below({.law = "a servo without position gain comes to its rate: error, as a part of the rate",
                     .level = "articulated_dynamics, ideal_pd",
                     .source = "1 - exp(-t kv / J)"},
                    error, 0.01, "");
}

// Duty at its limit of 0.9 all the time.
TEST(Servo, DcMotorHasItsSpeedTorqueLine) {
  Servo servo = motor();
  servo.duty_limit = 0.9;
  const std::string level = "articulated_dynamics, dc_motor";
  Arm free(servo, 0.1);
  free.hinge().set(properties::joint_target, 1000);
  free.rig.run(2.0);
  law::expect_near({.law = "servo without load: rate at a duty of 0.9", .level = level, .source = "0.9 no_load_speed"},
                   free.hinge().get(properties::joint_velocity), 0.9 * 6.6, 0.01 * 0.9 * 6.6, "rad/s");
  Arm blocked(servo, 1e6);
  blocked.hinge().set(properties::joint_target, 1);
  blocked.rig.run(0.1);
  law::expect_near({.law = "blocked servo: torque at a duty of 0.9", .level = level, .source = "0.9 stall_torque"},
                   blocked.hinge().get(properties::joint_torque), 0.9 * 6, 0.01 * 0.9 * 6, "N m");
  servo.torque_limit = 2;
  Arm limited(servo, 1e6);
  limited.hinge().set(properties::joint_target, 1);
  limited.rig.run(0.1);
  law::expect_near({.law = "blocked servo with a current limit: torque", .level = level, .source = "torque_limit"},
                   limited.hinge().get(properties::joint_torque), 2, 0.02, "N m");
}

/// A weightless trunk with an arm of 0.02 kg m^2 that can turn by 0.5 rad to each side.
ModelPtr limited_arm() {
  return std::make_shared<const Model>("limited", Chain{}
                                                      .base("trunk")
                                                      .with(properties::mass, 3.0)
                                                      .with(properties::inertia, diagonal(0.03))
                                                      .revolute("hinge", {0, 1, 0})
                                                      .with(properties::servo, motor())
                                                      .with(properties::joint_range, {-0.5, 0.5, 0})
                                                      .with(properties::mass, 0.5)
                                                      .with(properties::center_of_mass, {0, 0, -0.15})
                                                      .with(properties::inertia, diagonal(0.002)));
}

class Range : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Levels, Range, testing::ValuesIn(dynamic_levels()), level_name);

/// Drives the joint 1 rad beyond both ends. Results in degrees beyond them.
struct Driven {
  law::Worst hitting;   // in the first 0.4 s, which it needs to get there
  law::Worst pressing;  // in 0.1 s after that
};

Driven drive_beyond(const std::string& level) {
  Rig rig;
  rig.simulation.world().gravity = {};
  Entity& robot = rig.add("robot", limited_arm(), {.position = {0, 0, 1}});
  rig.attach_dynamics(robot, {.level = level, .on_ground = false});
  rig.simulation.initialize();
  auto hinge = robot.object("hinge");
  Driven result;
  for (const double side : {1.0, -1.0}) {
    hinge.set(properties::joint_target, 1.5 * side);
    for (int i = 0; i < 500; ++i) {
      rig.simulation.step();
      const double beyond = (side * hinge.get(properties::joint_position) - 0.5) / degree;
      (i < 400 ? result.hitting : result.pressing).see(beyond, "side", side, "step", i);
    }
  }
  return result;
}

// The servo presses with its stall torque, which bends the stop by half a degree, after it has hit it at full speed.
TEST_P(Range, JointDrivenBeyondItStaysNearItsEnd) {
  const Driven driven = drive_beyond(GetParam());
  const std::string source = "it stops there, up to what the stop bends";
  EXPECT_GT(law::Measured(driven.pressing).value, -1e-9) << "it did not get there";
  law::expect_below({.law = "joint driven 1 rad beyond its range: how far beyond the end it stays",
                     .level = GetParam(),
                     .source = source},
                    driven.pressing, 1, "deg");
  law::expect_below({.law = "joint driven 1 rad beyond its range: how far beyond the end it gets when it hits it",
                     .level = GetParam(),
                     .source = source},
                    driven.hitting, 1.2, "deg");
}

}  // namespace
}  // namespace murosimf::test
