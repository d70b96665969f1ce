// What motions take of servos that are too weak: the smoothed need, what the servo could have given, the message.
#include <tuple>

#include "murosimf/dynamics/servo/torque_watch.h"

#include <gtest/gtest.h>

#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/model/properties.h"
#include "tests/dynamics/part.h"
#include "tests/fixtures.h"

namespace murosimf::dynamics {
namespace {

using test::Alone;

constexpr double h = 1e-3;

/// 6 N m at rest, nothing at 8 rad/s, without friction.
Servo motor() { return {.type = "test", .stall_torque = 6, .no_load_speed = 8, .position_gain = 30}; }

struct Watch : Alone<TorqueWatch> {
  explicit Watch(const Chain& chain)
      : Alone(chain), torque(static_cast<std::size_t>(entity.model().size())), rate(torque.size()) {
    part->initialize();
  }
  void run(int steps) {
    for (int i = 0; i < steps; ++i, now += std::chrono::milliseconds(1)) {
      part->look({.now = now, .period = std::chrono::milliseconds(1)}, torque, rate);
    }
  }
  [[nodiscard]] double need(const char* name) { return object(name).get(properties::torque_need); }
  [[nodiscard]] Overload overload(const char* name) { return object(name).get(properties::overload); }
  double& torque_of(const char* name) { return torque[static_cast<std::size_t>(index(name))]; }
  double& rate_of(const char* name) { return rate[static_cast<std::size_t>(index(name))]; }

  Duration now{};
  std::vector<double> torque, rate;
};

Chain two_joints() {
  return Chain{}
      .base("base")
      .revolute("bare", {0, 1, 0})
      .revolute("knee", {0, 1, 0})
      .with(properties::servo, motor())
      .revolute("unlimited", {0, 1, 0})
      .with(properties::servo, {.law = "ideal_pd", .position_gain = 5});
}

// Implicit Euler of T' = (torque - T) / 20 ms: T = torque (1 - (1 + h / 20 ms)^-n).
TEST(TorqueWatch, NeedIsSmoothedOverTwentyMilliseconds) {
  Watch watch(two_joints());
  watch.torque_of("knee") = -4;
  watch.torque_of("bare") = 100;
  for (int n = 1; n <= 60; ++n) {
    watch.run(1);
    EXPECT_NEAR(watch.need("knee"), -4 * (1 - std::pow(1 + h / 0.02, -n)), 1e-12) << n;
  }
  EXPECT_EQ(watch.need("bare"), 0) << "it has no servo";
  EXPECT_EQ(watch.overload("knee").needed, 0) << "4 of 6 N m";
}

TEST(TorqueWatch, InitializeForgetsEverything) {
  Watch watch(two_joints());
  watch.torque_of("knee") = 9;
  watch.run(100);
  EXPECT_GT(watch.overload("knee").needed, 6);
  watch.part->initialize();
  EXPECT_EQ(watch.need("knee"), 0);
  EXPECT_EQ(watch.overload("knee").needed, 0);
  EXPECT_EQ(watch.overload("knee").time, 0);
}

// Rule: a motor that runs with its torque has less to give, one that is driven against it has more: 6 -+ 6/8 w.
TEST(TorqueWatch, ServoGivesWhatItsLineLeavesInTheDirectionOfTheNeed) {
  for (const auto& [torque, rate, given] :
       {std::tuple{9.0, 2.0, 4.5}, {9.0, -2.0, 7.5}, {-9.0, 2.0, 7.5}, {-9.0, -2.0, 4.5}, {9.0, 12.0, 0.0}}) {
    Watch watch(two_joints());
    watch.torque_of("knee") = torque;
    watch.rate_of("knee") = rate;
    watch.run(1000);
    const Overload worst = watch.overload("knee");
    EXPECT_NEAR(worst.given, given, 1e-12) << torque << " " << rate;
    EXPECT_NEAR(worst.needed, 9, 1e-9);
    EXPECT_EQ(worst.rate, rate);
  }
}

// The largest excess is kept, with its instant: 8 N m for 0.2 s, then less.
TEST(TorqueWatch, LargestExcessIsKeptWithItsTime) {
  Watch watch(two_joints());
  watch.torque_of("knee") = 8;
  watch.run(200);
  const Overload at_first = watch.overload("knee");
  EXPECT_NEAR(at_first.needed, 8, 1e-3);
  EXPECT_NEAR(at_first.time, 0.199, 1e-9);
  watch.torque_of("knee") = 7;
  watch.run(200);
  EXPECT_EQ(watch.overload("knee").time, at_first.time);
  watch.torque_of("knee") = 7.5;  // less than before, but of a motor that runs
  watch.rate_of("knee") = 4;
  watch.run(300);
  EXPECT_NEAR(watch.overload("knee").given, 3, 1e-12);
  EXPECT_NEAR(watch.overload("knee").time, 0.699, 1e-9);
  EXPECT_NEAR(watch.overload("knee").needed, 7.5, 1e-3);
  EXPECT_EQ(watch.overload("unlimited").needed, 0);
}

/// Joints j0, j1, ... with the same servo.
Chain row_of_joints(int count) {
  Chain chain = Chain{}.base("base");
  for (int i = 0; i < count; ++i) {
    chain.revolute("j" + std::to_string(i), {0, 1, 0}).with(properties::servo, motor());
  }
  return chain;
}

TEST(TorqueWatch, MessageNamesTheWeakestServosInOrder) {
  Watch watch(row_of_joints(7));
  EXPECT_EQ(overload_message(watch.entity), "");
  watch.torque_of("j2") = 9;
  watch.rate_of("j2") = 0.8;
  watch.run(500);
  EXPECT_EQ(overload_message(watch.entity),
            "robot: not feasible: j2 needs 9.0 Nm, servo gives 5.4 at 0.8 rad/s (at 0.50 s)");
  const auto also = [&] { return overload_message(watch.entity).substr(overload_message(watch.entity).find(')') + 1); };
  watch.torque_of("j1") = -7;
  watch.run(500);
  EXPECT_EQ(also(), "; also j1");
  watch.torque_of("j6") = 7.5;
  watch.torque_of("j0") = 6.5;
  watch.run(500);
  EXPECT_EQ(also(), "; also j6, j1, j0") << "the largest excess first";
  watch.torque_of("j3") = watch.torque_of("j4") = 6.1;
  watch.run(500);
  EXPECT_EQ(also(), "; also j6, j1, j0 and 2 more");
  EXPECT_TRUE(fixtures::says(overload_message(watch.entity), {"j2 needs 9.0"}));
}

TEST(TorqueWatch, SaysNothingOfEntitiesThatAreNotWatchedOrFrozen) {
  Simulation simulation;
  Entity& other = simulation.world().add("other", std::make_shared<const Model>("other", row_of_joints(1)));
  EXPECT_EQ(overload_message(other), "");
  Watch watch(row_of_joints(1));
  watch.torque_of("j0") = 9;
  watch.run(500);
  EXPECT_NE(overload_message(watch.entity), "");
  watch.entity.freeze("test");
  EXPECT_EQ(overload_message(watch.entity), "");
}

TEST(TorqueWatch, RotorInertiaIsThatOfServoAndJoint) {
  Servo servo = motor();
  servo.rotor_inertia = 0.012;
  const Model model("odd", Chain{}
                               .base("base")
                               .revolute("both", {0, 1, 0})
                               .with(properties::servo, servo)
                               .with(properties::joint_armature, 0.005)
                               .revolute("servo", {0, 1, 0})
                               .with(properties::servo, servo)
                               .revolute("armature", {0, 1, 0})
                               .with(properties::joint_armature, 0.005)
                               .revolute("none", {0, 1, 0}));
  EXPECT_DOUBLE_EQ(rotor_inertia(model, model.object_index("both")), 0.017);
  EXPECT_DOUBLE_EQ(rotor_inertia(model, model.object_index("servo")), 0.012);
  EXPECT_DOUBLE_EQ(rotor_inertia(model, model.object_index("armature")), 0.005);
  EXPECT_EQ(rotor_inertia(model, model.object_index("none")), 0);
}

}  // namespace
}  // namespace murosimf::dynamics
