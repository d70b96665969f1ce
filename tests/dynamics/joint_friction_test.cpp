// Friction of joints is a budget: it holds a loaded joint still, and takes a constant torque from one that slides.
#include <gtest/gtest.h>

#include "murosimf/collision/contact_properties.h"
#include "murosimf/dynamics/motion_properties.h"
#include "tests/law.h"
#include "tests/physics/friction_sets.h"
#include "tests/physics/servo_variants.h"
#include "tests/physics/walk.h"

namespace murosimf::test {
namespace {

constexpr const char* level = "articulated_dynamics";

/// An arm below a bolted ceiling that turns about y: 0.49 kg at 0.1 m.
struct Arm {
  static constexpr double mass = 0.49, length = 0.1, inertia = 1e-5;
  /// About the hinge, without rotor [kg m^2].
  static constexpr double at_hinge = inertia + mass * length * length;
  static constexpr double weight = mass * g * length;  // [N m] when it lies horizontally

  explicit Arm(const Servo& servo, double coulomb = 0, double rate_hz = 1000, bool heavy = true)
      : rig(0.8, 0, rate_hz) {
    if (!heavy) rig.simulation.world().gravity = {};
    Chain chain;
    chain.base("ceiling").revolute("hinge", {0, 1, 0});
    if (!servo.type.empty()) chain.with(properties::servo, servo);
    if (coulomb > 0) chain.with(properties::joint_friction, coulomb);
    chain.with(properties::mass, mass)
        .with(properties::center_of_mass, {0, 0, -length})
        .with(properties::inertia, diagonal(inertia));
    robot = &rig.add("arm", std::make_shared<const Model>("arm", std::move(chain)));
    rig.attach_dynamics(*robot, {.level = level, .on_ground = false, .tree = {.fixed_base = true}});
    rig.simulation.initialize();
  }
  ObjectAccess hinge() { return robot->object("hinge"); }
  [[nodiscard]] double angle() { return hinge().get(properties::joint_position); }
  [[nodiscard]] double rate() { return hinge().get(properties::joint_velocity); }
  void place(double angle, double rate = 0) {
    hinge().set(properties::joint_position, angle);
    hinge().set(properties::joint_velocity, rate);
  }

  Rig rig;
  Entity* robot;
};

class Models : public testing::TestWithParam<FrictionSet> {};
INSTANTIATE_TEST_SUITE_P(Friction, Models, testing::ValuesIn(friction_sets()),
                         [](const auto& set) { return set.param.name; });

// The servo's target is 10 degrees away from where the arm hangs aside: it comes to rest somewhere in between and stays.
TEST_P(Models, HoldsALoadedJointForAMinute) {
  for (const double rate_hz : {1000.0, 200.0}) {
    Arm arm(GetParam().servo, 0, rate_hz);
    arm.place(0.6);
    arm.hinge().set(properties::joint_target, 0.8);
    arm.rig.run(2.0);
    const double rest = arm.angle();
    EXPECT_GT(std::abs(rest - 0.8), 1e-3) << "without a load on the joint the test shows nothing";
    arm.rig.run(60.0);
    law::expect_below({.law = "joint held by friction under its load, 60 s, steps of " +
                              fmt::format("{} ms", 1000 / rate_hz),
                       .level = std::string(level) + ", " + GetParam().name,
                       .source = "what sticks does not move"},
                      std::abs(arm.angle() - rest), 1e-9, "rad");
  }
}

// Without motor the budget of M1 is K_c: the arm holds up to m g l sin(angle) = K_c.
TEST(Friction, BreaksLooseAtTheAngleThatItsBudgetHolds) {
  constexpr double budget = 0.2;
  const double angle = std::asin(budget / Arm::weight);
  const auto moves = [&](double start) {
    Arm arm({}, budget);
    arm.place(start);
    arm.rig.run(1.0);
    return std::abs(arm.angle() - start) > 0;
  };
  EXPECT_FALSE(moves(0.99 * angle));
  EXPECT_TRUE(moves(1.01 * angle));
  double low = 0.9 * angle, high = 1.1 * angle;
  for (int i = 0; i < 16; ++i) {
    const double middle = 0.5 * (low + high);
    (moves(middle) ? high : low) = middle;
  }
  law::expect_near({.law = "pendulum that friction holds: angle at which it breaks loose",
                    .level = level,
                    .source = "m g l sin(angle) = F"},
                   low, angle, 1e-4 * angle, "rad");
}

// Without gravity friction alone stops the arm: a = F/J, the way to the stop w^2 J/(2 F). Semi-implicit Euler at 1 ms is
// off by half a step of the start rate.
TEST(Friction, StopsAMovingArmWithAConstantTorque) {
  constexpr double budget = 0.05, start = 4;
  Arm arm({}, budget, 1000, false);
  arm.place(0, start);
  arm.rig.run(0.05);
  const double deceleration = (start - arm.rate()) / 0.05;
  law::expect_near({.law = "arm braked by friction: deceleration", .level = level, .source = "F/J"}, deceleration,
                   budget / Arm::at_hinge, 1e-9, "rad/s^2");
  arm.rig.run(2.0);
  const double way = start * start * Arm::at_hinge / (2 * budget);
  law::expect_near({.law = "arm braked by friction: angle to the stop", .level = level, .source = "w^2 J/(2 F)"},
                   arm.angle(), way, 0.5e-3 * start + 1e-6, "rad");
  EXPECT_EQ(arm.rate(), 0);
}

/// Two arms one below the other, with friction in both joints, at 1 kHz.
TEST(Friction, NeverGivesEnergy) {
  Chain chain;
  chain.base("ceiling");
  for (const char* name : {"upper", "lower"}) {
    chain.revolute(name, {0, 1, 0})
        .with(properties::joint_friction, 0.05)
        .with(properties::mass, 0.5)
        .with(properties::center_of_mass, {0, 0, -0.1})
        .with(properties::inertia, diagonal(1e-4));
    chain.translation({0, 0, -0.2});
  }
  Rig rig;
  rig.simulation.world().gravity = {};
  Entity& robot = rig.add("arms", std::make_shared<const Model>("arms", std::move(chain)));
  rig.attach_dynamics(robot, {.level = level, .on_ground = false, .tree = {.fixed_base = true}});
  rig.simulation.initialize();
  robot.object("upper").set(properties::joint_velocity, 3);
  robot.object("lower").set(properties::joint_velocity, -8);
  const auto energy = [&] {
    double sum = 0;
    for (const char* name : {"upper", "lower"}) {
      auto body = robot.object(name);
      const Vec3d w = body.get(properties::angular_velocity);
      const Vec3d v =
          body.get(properties::linear_velocity) + cross(w, body.get(properties::orientation) * Vec3d{0, 0, -0.1});
      sum += 0.25 * dot(v, v) + 0.5e-4 * dot(w, w);
    }
    return sum;
  };
  rig.simulation.step();
  double before = energy();
  const double first = before;
  law::Worst growth;
  for (int i = 0; i < 2000; ++i) {
    rig.simulation.step();
    const double now = energy();
    growth.see(now - before, "step", i);
    before = now;
  }
  // between two steps centrifugal terms of a first-order integrator move energy by h^2
  law::expect_below({.law = "double arm braked by friction: largest growth of energy in a step, of its start",
                     .level = level,
                     .source = "friction takes only"},
                    law::Measured(growth).value / first, 1e-4, "");
  EXPECT_EQ(before, 0) << "it stands in the end";
}

/// A servo without friction of its own: stall torque 6 N m, no-load rate 6.6 rad/s, 12 V.
Servo motor() {
  return {.type = "test",
          .voltage = 12,
          .stall_torque = 6,
          .no_load_speed = 6.6,
          .position_gain = 30,
          .rotor_inertia = 0.01};
}

/// An arm without gravity.
struct Weightless : Arm {
  explicit Weightless(const Servo& servo) : Arm(servo, 0, 1000, false) {}
};

TEST(ServoMotor, CoastsWithFrictionOnlyWhileTorqueIsOff) {
  Servo servo = motor();
  servo.friction = {.coulomb = 0.03};
  Weightless arm(servo);
  arm.hinge().set(properties::torque_enabled, 0);
  arm.hinge().set(properties::joint_target, 2);
  arm.place(0, 3);
  arm.rig.run(0.2);
  const double inertia = Arm::at_hinge + servo.rotor_inertia;
  law::expect_near({.law = "open bridge: deceleration of a joint", .level = level, .source = "F/J, no back-EMF"},
                   (3 - arm.rate()) / 0.2, 0.03 / inertia, 1e-9, "rad/s^2");
  EXPECT_LT(std::abs(arm.hinge().get(properties::joint_torque) + 0.03), 1e-12) << "friction of the gear alone";
}

TEST(ServoMotor, HalfTheVoltageHalvesStallTorqueAndNoLoadRate) {
  Weightless free(motor());
  free.hinge().set(properties::supply_voltage, 6);
  free.hinge().set(properties::joint_target, 1000);
  free.rig.run(1.0);
  law::expect_near({.law = "servo at half its voltage: no-load rate", .level = level, .source = "V/k_t"}, free.rate(),
                   3.3, 1e-3, "rad/s");
  Servo heavy = motor();
  heavy.rotor_inertia = 1e6;
  Weightless blocked(heavy);
  blocked.hinge().set(properties::supply_voltage, 6);
  blocked.hinge().set(properties::joint_target, 1);
  blocked.rig.run(0.01);
  law::expect_near({.law = "blocked servo at half its voltage: torque", .level = level, .source = "k_t V/R"},
                   blocked.hinge().get(properties::joint_torque), 3.0, 3 * 1e-6, "N m");
}

TEST(ServoMotor, LeavesAnErrorInsideTheDeadBandAlone) {
  Servo servo = motor();
  servo.dead_band = 0.02;
  Weightless arm(servo);
  arm.hinge().set(properties::joint_target, 0.0199);
  arm.rig.run(0.5);
  EXPECT_EQ(arm.angle(), 0);
  arm.hinge().set(properties::joint_target, 0.5);
  arm.rig.run(3.0);
  law::expect_between({.law = "servo with a dead band of 0.02 rad: where it stops, against its target",
                       .level = level,
                       .source = "nothing acts inside the band"},
                      arm.angle() - 0.5, -0.02 - 1e-9, 0.02 + 1e-9, "rad");
  EXPECT_LT(std::abs(arm.rate()), 1e-9);
}

TEST(ServoMotor, StandsWithinAStepOfItsEncoder) {
  Servo servo = motor();
  servo.encoder_step = 2 * pi / 4096;
  servo.friction = {.coulomb = 0.02};  // holds against half a step: 30 N m/rad of it are 0.023 N m
  Weightless arm(servo);
  arm.hinge().set(properties::joint_target, 0.3);
  arm.rig.run(2.0);
  EXPECT_LT(std::abs(arm.angle() - 0.3), servo.encoder_step);
  const double rest = arm.angle();
  arm.rig.run(1.0);
  EXPECT_EQ(arm.angle(), rest);
  arm.hinge().set(properties::joint_target, 0.3 + 0.4 * servo.encoder_step);
  arm.rig.run(1.0);
  EXPECT_LT(std::abs(arm.angle() - rest), servo.encoder_step) << "at most one step further";
}

// The bus takes targets over every 20 ms: what is set in between has to wait for the next time.
TEST(ServoMotor, KnowsATargetFromTheNextTimeOfItsBusOn) {
  Servo servo = motor();
  servo.command_period = 0.02;
  Weightless arm(servo);
  arm.rig.run(0.005);
  arm.hinge().set(properties::joint_target, 0.5);
  arm.rig.run(0.015);
  EXPECT_EQ(arm.angle(), 0);
  arm.rig.run(0.001);
  EXPECT_GT(arm.angle(), 0);
  EXPECT_EQ(arm.hinge().get(properties::sent_target), 0.5);
}

// Blocked at full duty: R i^2 heats, R grows with the temperature; the closed form is that of a linear equation while
// the change of R is small (0.39 % per kelvin; here 1 K).
TEST(ServoMotor, HeatsUpExponentiallyAndIsDerated) {
  Servo servo = motor();
  servo.rotor_inertia = 1e6;
  servo.torque_limit = 0.3;
  servo.heat = {.heat_capacity = 5, .thermal_resistance = 4};
  Weightless arm(servo);
  arm.hinge().set(properties::joint_target, 1);
  arm.rig.run(30.0);
  const double k_t = 12 / 6.6, R = k_t * 12 / 6, i = 0.3 / k_t, power = R * i * i;
  const double rise = 4 * power, copper = 1 + 0.0039 * 0.5 * rise * (1 - std::exp(-1.5));
  law::expect_near({.law = "servo that holds: rise of its temperature after 30 s",
                    .level = level,
                    .source = "P R_th (1 - exp(-t/(C R_th)))"},
                   arm.hinge().get(properties::servo_temperature) - 25, rise * (1 - std::exp(-1.5)) * copper,
                   5e-3 * rise, "K");
  servo.torque_limit = 0;
  servo.heat = {.heat_capacity = 0.5, .thermal_resistance = 4, .derating_temperature = 60, .temperature_limit = 80};
  Weightless hot(servo);
  hot.hinge().set(properties::joint_target, 1);
  hot.rig.run(60.0);
  const double T = hot.hinge().get(properties::servo_temperature);
  EXPECT_GT(T, 60);
  EXPECT_LT(T, 80);
  law::expect_near({.law = "hot servo: torque, as a part of stall torque", .level = level, .source = "linear derating"},
                   hot.hinge().get(properties::joint_torque) / 6, (80 - T) / 20, 1e-3, "");
}

/// The state of the play while the arm moves.
struct Play {
  double least = 1, most = -1;
  void see(double x) {
    least = std::min(least, x);
    most = std::max(most, x);
  }
};

Servo with_backlash(double play) {
  Servo servo = motor();
  servo.backlash = play;
  return servo;
}

// The rotor is held by friction of the gear; a push moves the arm freely from one side to the other. It arrives with
// 0.03 rad/s, so where it is stopped is known to 0.03 mrad.
TEST(Backlash, LetsTheJointMoveFreelyByItsPlay) {
  constexpr double play = 0.02;
  Servo servo = with_backlash(play);
  servo.friction = {.coulomb = 1};
  Weightless arm(servo);
  arm.hinge().set(properties::torque_enabled, 0);
  Play angle;
  for (const double push : {1e-4, -1e-4, 1e-4}) {
    arm.hinge().set(properties::applied_force, Wrenchd{{0, push, 0}, {}});
    arm.rig.run(4.0);
    angle.see(arm.angle());
  }
  law::expect_near({.law = "gear with backlash that is pushed to both sides: free way", .level = level, .source = "b"},
                   angle.most - angle.least, play, 1e-4, "rad");
}

TEST(Backlash, RestsOnOneSideUnderALoad) {
  Servo servo = with_backlash(0.02);
  servo.friction = {.coulomb = 0.02};
  Arm arm(servo);
  arm.hinge().set(properties::joint_target, 0.5);
  arm.rig.run(5.0);
  EXPECT_EQ(arm.hinge().get(properties::backlash_side), 1) << "the motor lifts";
  const double rest = arm.angle();
  arm.rig.run(10.0);
  law::expect_below({.law = "arm held by a servo with backlash: motion in 10 s", .level = level, .source = "it rests"},
                    std::abs(arm.angle() - rest), 1e-9, "rad");
}

// Without load and without friction the arm wanders within its play, driven by nothing but the servo.
TEST(Backlash, SwingsWithinItsPlay) {
  constexpr double play = 0.02;
  Weightless arm(with_backlash(play));
  arm.place(0.05);
  arm.rig.run(3.0);
  Play angle;
  for (int i = 0; i < 3000; ++i) {
    arm.rig.simulation.step();
    angle.see(arm.angle());
  }
  law::expect_below({.law = "servo with backlash, no load, no friction: width of the cycle that is left",
                     .level = level,
                     .source = "at most the play on both sides"},
                    angle.most - angle.least, 2 * play, "rad");
}

TEST(Backlash, NeverGivesEnergy) {
  Servo servo = with_backlash(0.05);
  Weightless arm(servo);
  arm.hinge().set(properties::torque_enabled, 0);
  arm.place(0, 4);
  const auto energy = [&] {
    const double w = arm.rate(), rotor = arm.hinge().get(properties::rotor_rate);
    return 0.5 * Arm::at_hinge * w * w + 0.5 * servo.rotor_inertia * rotor * rotor;
  };
  double before = energy();
  law::Worst growth;
  int meetings = 0;
  for (int i = 0; i < 2000; ++i) {
    arm.rig.simulation.step();
    growth.see(energy() - before, "step", i);
    if (i > 0 && energy() < before - 1e-9) ++meetings;
    before = energy();
  }
  EXPECT_GE(meetings, 1) << "the sides never met";
  law::expect_below({.law = "joint and rotor meet in their play: growth of energy",
                     .level = level,
                     .source = "inelastic"},
                    growth, 1e-12, "J");
}

// The gain is that of the P gain 32 of the set (0.158/rad * 32 * stall torque). Loads take a third of the torque away.
TEST(Friction, OfAPublishedServoLetsTheRobotWalk) {
  const ModelPtr model = kid21_with_m6();
  ASSERT_GT(model->find(properties::servo, *model->find_object("j_l_shin"))->friction.motor_load, 0.3);
  const Walk result = walk({.dynamics = {.level = level}, .command = {0.2, 0, 0}, .seconds = 20, .model = model});
  law::expect_below({.law = "walk of 20 s at 0.2 m/s with servos of friction model M6: largest lean",
                     .level = level,
                     .source = "it does not fall"},
                    result.lean, 20, "deg");
  law::expect_above({.law = "walk of 20 s at 0.2 m/s with servos of friction model M6: way forward",
                     .level = level,
                     .source = "it gets ahead"},
                    result.moved.x, 2.5, "m");
}

}  // namespace
}  // namespace murosimf::test
