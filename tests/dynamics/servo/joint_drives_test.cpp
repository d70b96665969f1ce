// What acts in a joint from inside, number by number, and that stops hold light links at long steps.
#include "murosimf/dynamics/servo/joint_drives.h"

#include <gtest/gtest.h>

#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/model/properties.h"
#include "tests/dynamics/part.h"
#include "tests/fixtures.h"
#include "tests/physics/rig.h"

namespace murosimf::dynamics {
namespace {

constexpr double h = 2e-3;

/// 40 N m/rad, 1.5 N m s/rad of the servo, a weak damper and spring of the joint, ends at -0.4 and 0.9.
Chain drives_chain() {
  const Servo servo{.law = "ideal_pd",
                    .stall_torque = 50,
                    .position_gain = 40,
                    .velocity_gain = 1.5,
                    .rotor_inertia = 0.01,
                    .friction = {.coulomb = 0.2, .viscous = 0.07}};
  return Chain{}
      .base("base")
      .with(properties::mass, 3.0)
      .with(properties::inertia, diagonal(0.1))
      .revolute("all", {0, 1, 0})
      .with(properties::servo, servo)
      .with(properties::joint_armature, 0.003)
      .with(properties::joint_damping, 0.2)
      .with(properties::joint_stiffness, 5.0)
      .with(properties::joint_spring_reference, -0.3)
      .with(properties::joint_friction, 0.11)
      .with(properties::joint_range, {-0.4, 0.9, 0})
      .with(properties::mass, 0.5)
      .with(properties::inertia, diagonal(0.004))
      .revolute("free", {0, 1, 0})
      .with(properties::joint_armature, 0.004)
      .revolute("smooth", {0, 1, 0})
      .with(properties::servo, {.law = "ideal_pd", .position_gain = 2, .friction = {.viscous = 0.5}});
}

struct Drives : test::Alone<JointDrives> {
  Drives() : Alone(drives_chain()) { part->take_over(holder.columns.qd); }
  /// What acts in a joint; `viscous` is a part of it.
  struct Answer : multibody::FrictionalJoint<double> {
    JointDrive viscous;
  };
  [[nodiscard]] Answer drive(const char* name, double q, double qd, double dt = h) const {
    Answer answer;
    answer.viscous = part->drive(index(name), q, qd, dt, answer);
    return answer;
  }
};

TEST(JointDrives, AnswerIsTheSumOfItsParts) {
  Drives drives;
  drives.object("all").set(properties::joint_target, 0.5);
  ASSERT_TRUE(drives.part->take_targets(0.001));
  const double q = 0.3, qd = -0.7;
  const auto answer = drives.drive("all", q, qd);
  const double now = 40 * (0.5 - q) - 1.5 * qd;
  EXPECT_NEAR(answer.motor.now, now, 1e-12);
  EXPECT_NEAR(answer.motor.free.torque, now - h * 40 * qd, 1e-12);
  EXPECT_NEAR(answer.motor.free.inertia, h * 1.5 + h * h * 40, 1e-12);
  EXPECT_EQ(answer.motor.highest.torque, 50);
  EXPECT_EQ(answer.motor.lowest.torque, -50);
  EXPECT_NEAR(answer.viscous.torque, -0.07 * qd, 1e-12);
  EXPECT_NEAR(answer.viscous.inertia, h * 0.07, 1e-12);
  EXPECT_NEAR(answer.torque, answer.viscous.torque - 0.2 * qd - 5 * (q + 0.3), 1e-12);
  EXPECT_NEAR(answer.inertia, answer.viscous.inertia + 0.013 + h * 0.2 + 0.25 * h * h * 5, 1e-12);
  EXPECT_EQ(answer.coulomb, 0.11);
  ASSERT_NE(answer.gear, nullptr);
  EXPECT_EQ(answer.gear->coulomb, 0.2);
  EXPECT_NEAR(drives.part->firm_inertia(drives.index("all")), 0.013, 1e-15);
}

TEST(JointDrives, JointWithoutServoIsFree) {
  Drives drives;
  const auto answer = drives.drive("free", 0.3, 2);
  EXPECT_EQ(answer.torque, 0);
  EXPECT_EQ(answer.inertia, 0.004);
  EXPECT_EQ(answer.gear, nullptr);
  EXPECT_EQ(answer.coulomb, 0);
  EXPECT_EQ(answer.motor.now, 0);
  EXPECT_EQ(answer.motor.free.torque, 0);
}

TEST(JointDrives, GearThatIsOnlyViscousHasNoBudget) {
  Drives drives;
  const auto answer = drives.drive("smooth", 0.3, 2, 0);
  EXPECT_EQ(answer.gear, nullptr);
  EXPECT_NEAR(answer.motor.now, -2 * 0.3, 1e-15);
  EXPECT_NEAR(answer.torque, -0.5 * 2, 1e-15);
  EXPECT_EQ(answer.inertia, 0) << "the plain torque of this instant";
}

TEST(JointDrives, AnyDryNumberOfAGearMakesABudget) {
  for (double GearFriction::*number :
       {&GearFriction::coulomb, &GearFriction::stribeck, &GearFriction::motor_load, &GearFriction::external_load,
        &GearFriction::stribeck_motor_load, &GearFriction::stribeck_external_load, &GearFriction::quadratic_motor_load,
        &GearFriction::quadratic_external_load}) {
    Servo servo{.law = "ideal_pd", .position_gain = 2};
    servo.friction.*number = 0.01;
    test::Alone<JointDrives> drives(Chain{}.base("base").revolute("joint", {0, 1, 0}).with(properties::servo, servo));
    drives.part->take_over(drives.holder.columns.qd);
    multibody::FrictionalJoint<double> joint;
    (void)drives.part->drive(drives.index("joint"), 0, 0, h, joint);
    ASSERT_NE(joint.gear, nullptr);
    EXPECT_EQ(joint.gear->*number, 0.01);
  }
}

// -k (q + h qd - end) - d qd with the inertia h d + h^2 k, of the end ahead.
TEST(JointDrives, StopIsASpringAndADamperOfTheEndOfTheStep) {
  Drives drives;
  const JointStop stop = joint_stop(drives.entity.model(), drives.index("all"), -0.4, 0.9);
  const auto& [k, d] = stop.implicit;
  ASSERT_GT(k, 100);
  const auto upper = drives.drive("all", 0.85, 40).end;
  EXPECT_EQ(upper.direction, 1);
  EXPECT_NEAR(upper.gap, 0.9 - (0.85 + h * 40), 1e-15);
  EXPECT_NEAR(upper.line.torque, -k * (0.85 + h * 40 - 0.9) - d * 40, 1e-9);
  EXPECT_NEAR(upper.line.inertia, h * d + h * h * k, 1e-12);
  const auto lower = drives.drive("all", -0.42, 0).end;
  EXPECT_EQ(lower.direction, -1);
  EXPECT_NEAR(lower.gap, -0.02, 1e-15);
  EXPECT_NEAR(lower.line.torque, k * 0.02, 1e-9);
  EXPECT_TRUE(std::isinf(drives.drive("free", 50, 50).end.gap));
}

TEST(JointDrives, StopIsTheTorqueOfThisInstantInAnExplicitStep) {
  Drives drives;
  const JointStop stop = joint_stop(drives.entity.model(), drives.index("all"), -0.4, 0.9);
  const auto beyond = drives.drive("all", 0.91, 2, 0), inside = drives.drive("all", 0.89, 40, 0);
  const auto rest = [](double q, double qd) { return -0.07 * qd - 0.2 * qd - 5 * (q + 0.3); };
  EXPECT_NEAR(beyond.torque, rest(0.91, 2) - stop.explicitly.stiffness * 0.01 - stop.explicitly.damping * 2, 1e-9);
  EXPECT_NEAR(inside.torque, rest(0.89, 40), 1e-12);
  EXPECT_TRUE(std::isinf(beyond.end.gap));
}

TEST(JointDrives, InitializeStandsWhereTargetsAreInsideTheRange) {
  Drives drives;
  drives.object("all").set(properties::joint_target, -2);
  drives.object("free").set(properties::joint_target, -2);
  auto& columns = drives.holder.columns;
  std::fill(columns.qd.begin(), columns.qd.end(), 3.0);
  drives.part->initialize(columns.q, columns.qd);
  EXPECT_EQ(drives.object("all").get(properties::joint_position), -0.4);
  EXPECT_EQ(drives.object("free").get(properties::joint_position), -2);
  EXPECT_EQ(drives.object("all").get(properties::joint_velocity), 0);
  EXPECT_NEAR(drives.drive("all", 0, 0, 0).motor.now, 40 * -2, 30 + 1e-12) << "it knows the target, not its end";
}

/// A finger of 20 g on a heavy wall; a stop of 100 N m per radian holds it at steps of 20 ms, twelve times its own time.
TEST(JointStop, HoldsALightLinkAtLongSteps) {
  test::Rig rig(0.8, 0, 50);
  const auto model = std::make_shared<const Model>("finger", Chain{}
                                                                 .base("wall")
                                                                 .with(properties::mass, 40.0)
                                                                 .with(properties::inertia, diagonal(1.0))
                                                                 .revolute("joint", {0, 1, 0})
                                                                 .with(properties::mass, 0.02)
                                                                 .with(properties::center_of_mass, {0.05, 0, 0})
                                                                 .with(properties::inertia, diagonal(1e-5))
                                                                 .with(properties::joint_range, {-0.5, 0.6, 0}));
  Entity& robot = rig.add("finger", model);
  rig.attach_dynamics(robot, {.level = "articulated_dynamics",
                              .law = test::law_named("kelvin_voigt"),
                              .on_ground = false,
                              .tree = {.fixed_base = true}});
  rig.simulation.initialize();
  auto joint = robot.object("joint");
  joint.set(properties::joint_velocity, 10);
  double farthest = 0;
  for (int i = 0; i < 200; ++i) {
    rig.simulation.step();
    farthest = std::max(farthest, joint.get(properties::joint_position));
  }
  EXPECT_LT(farthest, 0.6 + 1e-3);
  EXPECT_NEAR(joint.get(properties::joint_position), 0.6, 1e-4);
  EXPECT_NEAR(joint.get(properties::joint_velocity), 0, 1e-6);
}

}  // namespace
}  // namespace murosimf::dynamics
