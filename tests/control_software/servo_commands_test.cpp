// Gains, torque limits, torque on and off, LEDs: what control software sets of servos, and what the joint makes of it. Oracle: statics and
// the pendulum.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "murosimf/control_software/controller_task.h"
#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/model/properties.h"
#include "tests/fixtures.h"
#include "tests/physics/rig.h"

namespace murosimf::control_software {
namespace {

constexpr double arm_mass = 0.5, arm_length = 0.2,
                 turning_inertia = 1e-3;                           // [kg], [m] to its center, [kg m^2] about that
constexpr double weight_torque = arm_mass * test::g * arm_length;  // [N m] if it is level

/// An arm that hangs from a bolted base, beside one without a servo.
ModelPtr hanging_arm(const Servo& servo) {
  const auto arm = [](const std::string& name) {
    return Chain{}
        .revolute(name, {0, 1, 0})
        .with(properties::joint_range, {-3, 3, 0})
        .with(properties::mass, arm_mass)
        .with(properties::center_of_mass, {0, 0, -arm_length})
        .with(properties::inertia, {turning_inertia, turning_inertia, turning_inertia, 0, 0, 0});
  };
  Chain chain;
  chain.base("base").with(properties::mass, 1.0).with(properties::inertia, {0.01, 0.01, 0.01, 0, 0, 0});
  chain.fork(arm("arm").with(properties::servo, servo), arm("free"));
  return std::make_shared<const Model>("arms", chain);
}

Servo springy() {
  return {.type = "pd", .law = "ideal_pd", .stall_torque = 5, .position_gain = 4, .velocity_gain = 0.4};
}

/// Sets its rows to what the test wants.
struct ServoSoftware final : ControlSoftware {
  explicit ServoSoftware(std::function<void()> step) : step_(std::move(step)) {}
  CallOutcome start() override { return {}; }
  CallOutcome step(Duration) noexcept override {
    step_();
    return {};
  }
  std::function<void()> step_;
};

struct BoltedArm {
  explicit BoltedArm(const Servo& servo, const std::vector<std::string>& names)
      : BoltedArm(hanging_arm(servo), names) {}
  BoltedArm(const ModelPtr& model, const std::vector<std::string>& names) : robot(rig.add("robot", model)) {
    const SoftwareMaker make = [&](Setup&, RobotPort& port, const SayLine&) {
      for (const std::string& name : names) rows.push_back(port.command(name));
      return std::make_unique<ServoSoftware>([this] { set(); });
    };
    task = &rig.simulation.attach<ControllerTask>("software", robot, 100, make, ControllerTaskOptions{});
    rig.attach_dynamics(robot, {.level = "articulated_dynamics", .on_ground = false, .tree = {.fixed_base = true}});
  }
  [[nodiscard]] double angle() const { return robot.object("arm").get(properties::joint_position); }
  [[nodiscard]] double rate() const { return robot.object("arm").get(properties::joint_velocity); }

  test::Rig rig;
  Entity& robot;
  std::vector<murosimf_command*> rows;
  std::function<void()> set = [] {};
  ControllerTask* task = nullptr;
};

// kp (target - q) = m g l sin(q)
TEST(ServoCommands, APositionGainCarriesAsMuchAsItSays) {
  for (const double gain : {4.0, 1.0, 40.0}) {
    BoltedArm arm(springy(), {"joint.target", "joint.position_gain", "joint.velocity_gain"});
    EXPECT_EQ(arm.rows[1]->values[0], 4) << "the servo's own";
    EXPECT_EQ(arm.rows[1]->values[1], 0) << "no servo";
    arm.set = [&] {
      arm.rows[0]->values[0] = 1.2;
      arm.rows[1]->values[0] = gain;
    };
    arm.rig.run(8);
    EXPECT_NEAR(gain * (1.2 - arm.angle()), weight_torque * std::sin(arm.angle()), 1e-6) << gain;
  }
}

TEST(ServoCommands, AVelocityGainBrakes) {
  const auto overshoot = [](double velocity_gain) {
    BoltedArm arm(springy(), {"joint.target", "joint.velocity_gain"});
    arm.set = [&] {
      arm.rows[0]->values[0] = 0.5;
      arm.rows[1]->values[0] = velocity_gain;
    };
    double most = 0;
    for (int i = 0; i < 300; ++i) {
      arm.rig.run(0.01);
      most = std::max(most, arm.angle());
    }
    EXPECT_EQ(arm.robot.object("arm").get(properties::servo_velocity_gain), velocity_gain);
    return most / arm.angle() - 1;
  };
  EXPECT_GT(overshoot(0.02), 0.3);
  EXPECT_LT(overshoot(0.8), 1e-3);
}

// kp (target - q) + feed-forward = m g l sin(q)
TEST(ServoCommands, AFeedForwardTorqueCarriesWhatTheGainNeedNot) {
  for (const double torque : {0.5 * weight_torque, -0.3 * weight_torque}) {
    BoltedArm arm(springy(), {"joint.target", "joint.feed_forward"});
    arm.set = [&] {
      arm.rows[0]->values[0] = 0.8;
      arm.rows[1]->values[0] = torque;
    };
    arm.rig.run(8);
    EXPECT_NEAR(springy().position_gain * (0.8 - arm.angle()) + torque, weight_torque * std::sin(arm.angle()), 1e-6);
    EXPECT_EQ(arm.task->port().refusal(), "");
  }
  BoltedArm arm(springy(), {"joint.feed_forward"});
  arm.set = [&] { arm.rows[0]->values[0] = -5.1; };
  arm.rig.run(0.1);
  EXPECT_EQ(arm.task->port().refusal(), "joint.feed_forward of arm is -5.1, not in -5 to 5");
}

// Without position gain I w' = kd (w_t - w) + feed-forward comes to w_t + feed-forward / kd; by implicit Euler the rest is divided by
// 1 + h kd / I in each step.
TEST(ServoCommands, AVelocityGainDampsToTheTargetRate) {
  constexpr double inertia = turning_inertia + arm_mass * arm_length * arm_length, damping = 0.05, rate = 2,
                   torque = 0.02;
  for (const char* law : {"ideal_pd", "dc_motor"}) {
    Servo servo = springy();
    servo.law = law;
    // a motor with so flat a speed-torque line that its own braking does not show
    servo.no_load_speed = 1e12;
    Chain chain;
    chain.base("base").with(properties::mass, 1.0).with(properties::inertia, {0.01, 0.01, 0.01, 0, 0, 0});
    chain.revolute("arm", {0, 0, 1})
        .with(properties::mass, arm_mass)
        .with(properties::center_of_mass, {arm_length, 0, 0})
        .with(properties::inertia, {turning_inertia, turning_inertia, turning_inertia, 0, 0, 0})
        .with(properties::servo, servo);
    BoltedArm arm(std::make_shared<const Model>("turntable", chain),
                  {"joint.position_gain", "joint.velocity_gain", "joint.velocity_target", "joint.feed_forward"});
    arm.set = [&] {
      for (const auto& [row, value] : {std::pair(0, 0.0), {1, damping}, {2, rate}, {3, torque}})
        arm.rows[row]->values[0] = value;
    };
    constexpr int steps = 300;
    const double h = 1 / arm.rig.rate, last = rate + torque / damping;
    arm.rig.run(steps * h);
    EXPECT_NEAR(arm.rate(), last * (1 - std::pow(1 + h * damping / inertia, -steps)), 1e-9) << law;
  }
}

/// [J] of the arm under gravity and a torque that stays the same.
double energy(const BoltedArm& arm, double torque) {
  constexpr double inertia = turning_inertia + arm_mass * arm_length * arm_length;
  return 0.5 * inertia * arm.rate() * arm.rate() + weight_torque * (1 - std::cos(arm.angle())) - torque * arm.angle();
}

// As long as the servo wants more than it may give, its torque is the limit: nothing brakes, and energy stays.
TEST(ServoCommands, ALimitedTorqueCarriesNoMore) {
  BoltedArm arm(springy(), {"joint.target", "joint.position_gain", "joint.torque_limit"});
  EXPECT_EQ(arm.rows[2]->values[0], 5);
  double limit = 0.6 * weight_torque;
  arm.set = [&] {
    arm.rows[0]->values[0] = 1.5;
    arm.rows[1]->values[0] = 80;
    arm.rows[2]->values[0] = limit;
  };
  double most = 0;
  for (int i = 0; i < 300; ++i) {
    arm.rig.run(0.01);
    EXPECT_NEAR(energy(arm, limit), 0, 0.01 * weight_torque) << i;
    most = std::max(most, arm.angle());
  }
  EXPECT_LT(most, 1.45);
  limit = 1.2 * weight_torque;
  arm.rig.run(6);
  EXPECT_NEAR(arm.angle(), 1.5, 0.02);
  EXPECT_EQ(software_report(arm.robot)->refused, 0U);
}

TEST(ServoCommands, MotorsHaveGainsAndLimitsToo) {
  const Servo motor{.type = "motor", .stall_torque = 5, .no_load_speed = 6, .position_gain = 10};
  BoltedArm arm(motor, {"joint.target", "joint.position_gain", "joint.velocity_gain", "joint.torque_limit"});
  arm.set = [&] {
    arm.rows[0]->values[0] = 1.2;
    arm.rows[1]->values[0] = 30;
    arm.rows[2]->values[0] = 0.5;
  };
  arm.rig.run(8);
  EXPECT_NEAR(30 * (1.2 - arm.angle()), weight_torque * std::sin(arm.angle()), 1e-6);
  const double limit = 0.3 * weight_torque, before = energy(arm, limit), held = arm.angle();
  arm.set = [&] {
    arm.rows[2]->values[0] = 0;
    arm.rows[3]->values[0] = limit;
  };
  for (int i = 0; i < 200; ++i) {
    arm.rig.run(0.01);
    EXPECT_NEAR(energy(arm, limit), before, 0.01 * weight_torque) << i;
    EXPECT_LT(arm.angle(), held + 0.01);
  }
}

TEST(ServoCommands, RefuseWhatNoServoHas) {
  BoltedArm arm(springy(), {"joint.position_gain", "joint.torque_limit", "joint.led", "robot.led"});
  arm.set = [&] {
    arm.rows[0]->values[0] = -1;
    arm.rows[0]->values[1] = 1;  // there is no servo
    arm.rows[1]->values[0] = 5.1;
    arm.rows[2]->values[0] = 1.5;
    arm.rows[3]->values[2] = -0.1;
  };
  arm.rig.run(0.01);
  EXPECT_EQ(software_report(arm.robot)->refused, 5U);
  EXPECT_EQ(software_report(arm.robot)->first_refusal, "at 0.000 s: joint.position_gain of arm is -1, not in 0 to 84");
  EXPECT_EQ(arm.robot.object("arm").get(properties::servo_position_gain), 4);
  EXPECT_EQ(arm.robot.object("arm").get(properties::servo_torque_limit), 5);
}

TEST(ServoCommands, LedsAreStatesOfTheRobot) {
  BoltedArm arm(springy(), {"joint.led", "robot.led"});
  arm.set = [&] {
    arm.rows[0]->values[1] = 0.5;
    arm.rows[1]->values[0] = 1;
    arm.rows[1]->values[2] = 0.25;
  };
  const std::uint64_t before = arm.rig.simulation.state_hash();
  arm.rig.run(0.01);
  EXPECT_EQ(arm.robot.object("free").get(properties::servo_led), 0.5);
  EXPECT_EQ(arm.robot.object("arm").get(properties::servo_led), 0);
  const Vec3d color = arm.robot.base().get(properties::robot_led);
  EXPECT_EQ(color.x, 1);
  EXPECT_EQ(color.y, 0);
  EXPECT_EQ(color.z, 0.25);
  EXPECT_NE(arm.rig.simulation.state_hash(), before);
  EXPECT_EQ(*arm.task->port().labels("robot.led"), (std::vector<std::string>{"red", "green", "blue"}));
}

/// State after half a second of eight equal robots on the ground, most of which have gains and limits of their own.
std::uint64_t hash_of_eight(bool lanes) {
  test::Rig rig;
  for (int number = 0; number < 8; ++number) {
    Entity& robot = rig.add("robot" + std::to_string(number), test::kid21());
    const SoftwareMaker make = [number](Setup&, RobotPort& port, const SayLine&) {
      murosimf_command* target = port.command("joint.target");
      std::vector<murosimf_command*> tuned;
      for (const char* name : {"joint.position_gain", "joint.velocity_gain", "joint.torque_limit",
                               "joint.velocity_target", "joint.feed_forward"}) {
        if (number > static_cast<int>(tuned.size())) tuned.push_back(port.command(name));
      }
      return std::make_unique<ServoSoftware>([target, tuned, number, cycle = 0]() mutable {
        for (std::size_t i = 0; i < target->count; ++i) target->values[i] = 0.02 * cycle;
        if (++cycle != 20) return;
        for (murosimf_command* row : tuned) {
          for (std::size_t i = 0; i < row->count; ++i) row->values[i] = 0.1 * number * (row->values[i] + 0.1);
        }
      });
    };
    rig.simulation.attach<ControllerTask>("software", robot, 100, make, ControllerTaskOptions{});
    rig.attach_dynamics(robot, {.level = "articulated_dynamics"});
  }
  rig.simulation.use_lanes(lanes);
  rig.run(0.5);
  EXPECT_EQ(rig.simulation.algorithms_in_lanes() > 0, lanes);
  const auto height = [&](const char* name) {
    return rig.simulation.world().entity(name).base().get(properties::position).z;
  };
  EXPECT_NE(height("robot1"), height("robot3")) << "they have other servos";
  return rig.simulation.state_hash();
}

TEST(ServoCommands, AreTheSameInLanes) { EXPECT_EQ(hash_of_eight(true), hash_of_eight(false)); }

// Without torque the arm is a pendulum of period 2 pi sqrt(I / (m g l)); with it, it stands still where it was told to be.
TEST(ServoCommands, WithoutTorqueAJointSwingsAsAPendulum) {
  BoltedArm arm(springy(), {"joint.target", "joint.torque_enabled", "joint.position_gain"});
  double on = 1;
  arm.set = [&] {
    arm.rows[0]->values[0] = 0.1;
    arm.rows[1]->values[0] = on;
    arm.rows[2]->values[0] = 80;
  };
  arm.rig.run(3);
  const double held = arm.angle();
  EXPECT_NEAR(held, 0.1, 2e-3);
  on = 0;
  const double w = std::sqrt(weight_torque / (turning_inertia + arm_mass * arm_length * arm_length));
  arm.rig.run(0.001);  // the software's cycle begins with this step
  for (int i = 0; i < 150; ++i) {
    arm.rig.run(0.01);
    const double t = 0.001 + 0.01 * (i + 1);
    EXPECT_NEAR(arm.angle(), held * std::cos(w * t), 3e-3) << t;
  }
  on = 1;
  arm.rig.run(2);
  EXPECT_NEAR(arm.angle(), held, 1e-4);
  EXPECT_NEAR(arm.rate(), 0, 1e-4);
}

}  // namespace
}  // namespace murosimf::control_software
