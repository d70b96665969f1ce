// Friction of joints is a budget: it holds a loaded joint still, and takes a constant torque from one that slides.
#include <gtest/gtest.h>

#include "tests/law.h"
#include "tests/physics/friction_sets.h"
#include "tests/physics/rig.h"

namespace murosimf::test {
namespace {

constexpr const char* level = "articulated_dynamics";

/// An arm below a bolted ceiling that turns about y: 0.49 kg at 0.1 m.
struct Arm {
  static constexpr double mass = 0.49, length = 0.1, inertia = 1e-5;
  /// About the hinge, without rotor [kg m^2].
  static constexpr double at_hinge = inertia + mass * length * length;
  static constexpr double weight = mass * g * length;  // [N m] when it lies horizontally

  explicit Arm(const Servo& servo, double coulomb = 0, double rate_hz = 1000) : rig(0.8, 0, rate_hz) {
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
  [[nodiscard]] double rate() { return hinge().get(properties::joint_rate); }
  void place(double angle, double rate = 0) {
    hinge().set(properties::joint_position, angle);
    hinge().set(properties::joint_rate, rate);
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

}  // namespace
}  // namespace murosimf::test
