// No servo drives its joint beyond the joint's largest rate, whatever moves behind it, at any level.
#include "murosimf/motion/rate_limit.h"

#include <gtest/gtest.h>

#include "murosimf/model/properties.h"
#include "murosimf/motion/mimic_joints.h"
#include "murosimf/motion/motion_properties.h"
#include "tests/fixtures.h"
#include "tests/physics/rig.h"

namespace murosimf::motion {
namespace {

constexpr double most = 2;  // [rad/s]

/// A bolted base and a limb with `inertia` [kg m^2] about a vertical hinge; with `arm` [m] its 1 kg hangs beside a level hinge.
ModelPtr limb_model(const Servo& servo, double inertia, double arm = 0) {
  Chain chain = Chain{}
                    .base("base")
                    .with(properties::mass, 3.0)
                    .with(properties::inertia, diagonal(0.1))
                    .revolute("j", arm == 0 ? Vec3d{0, 0, 1} : Vec3d{0, 1, 0})
                    .with(properties::joint_rate_limit, most)
                    .with(properties::servo, servo)
                    .with(properties::mass, 1.0)
                    .with(properties::center_of_mass, {arm, 0, 0})
                    .with(properties::inertia, diagonal(inertia));
  return std::make_shared<const Model>("limb", chain);
}

Servo ideal(double torque) {
  return {.law = "ideal_pd", .stall_torque = torque, .position_gain = 10 * torque, .velocity_gain = 0.5 * torque};
}

struct Limb {
  Limb(const ModelPtr& model, const std::string& level, double target, double rate = 1000,
       ReferenceKind kind = ReferenceKind::filter)
      : rig(0.8, 0, rate), entity(rig.add("limb", model)) {
    rig.attach_dynamics(entity, {.level = level,
                                 .on_ground = false,
                                 .options = {.reference = {.kind = kind}},
                                 .tree = {.fixed_base = level != "simplified_dynamics"}});
    rig.simulation.initialize();
    entity.object("j").set(properties::joint_target, target);
  }
  /// The largest rate on the way.
  double fastest(double time) {
    double fastest = 0;
    for (double t = 0; t < time; t += 1 / rig.rate) {
      rig.simulation.step();
      fastest = std::max(fastest, std::abs(entity.object("j").get(properties::joint_velocity)));
    }
    return fastest;
  }
  double q() { return entity.object("j").get(properties::joint_position); }

  test::Rig rig;
  Entity& entity;
};

class EveryLevel : public testing::TestWithParam<std::string> {};

TEST_P(EveryLevel, KeepsToTheLargestRate) {
  for (const double target : {1.5, -1.5}) {
    Limb limb(limb_model(ideal(5), 0.0024), GetParam(), target);
    EXPECT_LE(limb.fastest(0.5), most * (1 + 1e-9));
    EXPECT_NEAR(std::abs(limb.q()), most * 0.5, 0.1) << "it is nearly as fast as it may be";
    limb.rig.run(1.0);
    EXPECT_NEAR(limb.q(), target, 1e-3);
  }
}

INSTANTIATE_TEST_SUITE_P(RateLimit, EveryLevel,
                         testing::Values("simplified_dynamics", "full_dynamics", "articulated_dynamics"),
                         test::level_name);

TEST(RateLimit, HoldsForEveryReference) {
  for (const ReferenceKind kind : {ReferenceKind::filter, ReferenceKind::linear, ReferenceKind::exact}) {
    Limb limb(limb_model(ideal(5), 0.01), "full_dynamics", 1.5, 1000, kind);
    EXPECT_LE(limb.fastest(0.5), most * (1 + 1e-9));
    limb.rig.run(0.5);
    EXPECT_NEAR(limb.q(), 1.5, 1e-3) << static_cast<int>(kind);
  }
}

TEST(RateLimit, HoldsForAnyInertiaStepAndLaw) {
  const Servo motor{.law = "dc_motor", .stall_torque = 5, .no_load_speed = 8, .position_gain = 50};
  for (const double inertia : {1e-5, 1e-3, 0.1}) {
    for (const double rate : {100.0, 1000.0, 4000.0}) {
      for (const Servo& servo : {ideal(5), ideal(100), motor}) {
        Limb limb(limb_model(servo, inertia), "articulated_dynamics", 1.5, rate);
        EXPECT_LE(limb.fastest(0.5), most * (1 + 1e-9)) << inertia << ' ' << rate << ' ' << servo.law;
      }
    }
  }
}

// Gravity alone would have driven it to sqrt(2 g / 0.2 m): the servo brakes.
TEST(RateLimit, IsKeptUnderALoadThatPulls) {
  Limb limb(limb_model(ideal(20), 1e-3, 0.2), "articulated_dynamics", 1.5);
  EXPECT_LE(limb.fastest(0.6), most * 1.01);
}

TEST(RateLimit, IsNoneOfAServoThatIsSwitchedOff) {
  Limb limb(limb_model(ideal(20), 1e-3, 0.2), "articulated_dynamics", 0);
  limb.entity.object("j").set(properties::torque_enabled, 0);
  EXPECT_GT(limb.fastest(0.6), 1.5 * most);
}

TEST(RateLimit, LeavesSlowMotionAlone) {
  multibody::MotorTorque<double> torque{3, {2.9, 0.001}, {5}, {-5}};
  limit_rate(rate_limit(ideal(5), 10), 1.0, 0.1, 0.0, torque);
  EXPECT_EQ(torque.now, 3);
  const multibody::TorqueLine<double> line = followed_line(torque, 1.0, 0.0);
  EXPECT_DOUBLE_EQ(line.torque, 2.9);
  EXPECT_EQ(line.inertia, 0.001);
}

TEST(RateLimit, OfAFollowerIsThatOfItsLeader) {
  const Model model("pair", Chain{}
                                .base("base")
                                .with(properties::mass, 1.0)
                                .with(properties::inertia, diagonal(0.1))
                                .revolute("a", {0, 0, 1})
                                .with(properties::joint_rate_limit, 3.0)
                                .with(properties::mass, 1.0)
                                .with(properties::inertia, diagonal(0.1))
                                .revolute("b", {0, 0, 1})
                                .with(properties::joint_rate_limit, 4.0)
                                .with(properties::joint_coupling, {"a", -2.0, 0.0})
                                .with(properties::mass, 1.0)
                                .with(properties::inertia, diagonal(0.1)));
  const MimicJoints joints(model);
  EXPECT_EQ(joints.rate_limit(model.object_index("a")), 2);
  EXPECT_EQ(joints.rate_limit(model.object_index("b")), 4);
}

TEST(RateLimit, MustNotBeNegative) {
  const auto of = [](double rate) {
    return joint_rate_limit(Model("m",
                                  Chain{}.base("b").revolute("j", {0, 0, 1}).with(properties::joint_rate_limit, rate)),
                            1);
  };
  EXPECT_EQ(of(3), 3);
  EXPECT_TRUE(std::isinf(of(0))) << "none";
  EXPECT_EQ(fixtures::error_of([&] { (void)of(-1); }),
            "model 'm', joint 'j': a largest rate of -1 rad/s (m/s) is none; it must not be negative");
}

}  // namespace
}  // namespace murosimf::motion
