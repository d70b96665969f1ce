// One joint with dry friction, pass by pass: whichever way friction is put in, it ends at the rate of the closed form.
#include <gtest/gtest.h>

#include "murosimf/model/model.h"
#include "murosimf/model/properties.h"
#include "murosimf/multibody/friction_solver.h"
#include "murosimf/multibody/kinematics.h"
#include "murosimf/multibody/servo/gear_friction.h"
#include "tests/fixtures.h"

namespace murosimf::multibody {
namespace {

constexpr double h = 2e-3, J = 0.02, rotor = 0.005;
const GearFriction gear{.coulomb = 0.15, .motor_load = 0.2, .external_load = 0.3};

/// A wheel about a slanted axis on a wall, without gravity.
struct Wheel {
  Wheel() : model("wheel", chain()), state(model.size()), links(2), bodies(2), joints(2) {
    state.R[0] = Mat3d{};
    joints[1].gear = &gear;
    joints[1].coulomb = 0.05;
    joints[1].inertia = rotor;
  }
  static Chain chain() {
    return Chain{}
        .base("wall")
        .revolute("axle", {0.6, 0, 0.8})
        .with(properties::mass, 3.0)
        .with(properties::inertia, diagonal(J));
  }
  /// The rate after the step.
  double step(double rate, double torque, double motor_torque, double pushed, double load, Loads loads) {
    state.qd[1] = joints[1].rate = rate;
    joints[1].torque = torque;
    joints[1].motor.now = motor_torque;
    joints[1].load = load;
    poses<double>(model.tree(), state.q, state.r, state.R);
    link_motions<double>(model.tree(), state.r, state.R, state.w[0], state.qd, links);
    clear_loads<double>(bodies);
    bodies[0].acceleration = {};
    add_load<double>(bodies[1], {pushed * Vec3d{0.6, 0, 0.8}, {}}, {});
    sweep_with_friction<double>(model.tree(), links, bodies, joints, loads, h);
    wrong = accelerate_with_friction<double>(model.tree(), links, bodies, joints, {});
    return rate + h * bodies[1].joint_acceleration;
  }
  Model model;
  fixtures::State<double> state;
  std::vector<LinkMotion<double>> links;
  std::vector<ArticulatedLink<double>> bodies;
  std::vector<FrictionalJoint<double>> joints;
  double wrong = 0;
};

// p = D qd / h + tau + tau_e; it ends at sign(p) (|p| - F) h / D, or at rest if |p| < F.
TEST(SlidingJoint, EndsAtTheRateOfTheClosedFormInEveryPass) {
  constexpr double D = J + rotor;
  for (const double rate : {1.3, -0.4, 0.01, 0.0}) {
    for (const double torque : {0.9, -0.5, 0.02}) {
      for (const double pushed : {0.3, -1.1, 0.0}) {
        const double F = 0.05 + dry_friction(gear, rate, torque, pushed), p = D * rate / h + torque + pushed;
        const double end = std::abs(p) < F ? 0 : std::copysign((std::abs(p) - F) * h / D, p);
        for (const Loads loads : {Loads::of_last_pass, Loads::of_last_step}) {
          Wheel wheel;
          const double found = wheel.step(rate, torque, torque, pushed, pushed, loads);
          const bool slow = loads == Loads::of_last_step && std::abs(end) < 1e-3;  // a damper there
          if (!slow) {
            EXPECT_NEAR(found, end, 1e-12) << rate << " " << torque << " " << pushed;
          }
          EXPECT_NEAR(wheel.joints[1].budget, F, 1e-14);
          EXPECT_NEAR(wheel.joints[1].drive, p - pushed, 1e-12);
          EXPECT_NEAR(wheel.joints[1].load, pushed, 1e-12);
          EXPECT_EQ(wheel.wrong, 0);
          EXPECT_EQ(wheel.joints[1].direction, std::abs(p) < F ? 0 : std::copysign(1, p));
        }
      }
    }
  }
}

TEST(SlidingJoint, RepeatedPassKeepsItsBudget) {
  Wheel wheel;
  wheel.joints[1].budget = 0.4;
  const double p = (J + rotor) * 1.0 / h + 0.5 + 0.2;
  EXPECT_NEAR(wheel.step(1.0, 0.5, 9, 0.2, 0, Loads::of_repeated_pass), (p - 0.4) * h / (J + rotor), 1e-12);
  EXPECT_EQ(wheel.joints[1].budget, 0.4);
}

// Rule: within an island the load of the step before decides; where it was another one, friction was wrong.
TEST(SlidingJoint, WrongDecisionsAreCounted) {
  Wheel wheel;
  EXPECT_NEAR(wheel.step(0, 0.1, 0, 0, 0, Loads::of_last_step), 0, 1e-12) << "0.2 N m hold it";
  EXPECT_EQ(wheel.wrong, 0);
  (void)wheel.step(0, 0.1, 0, 0.5, 0, Loads::of_last_step);
  EXPECT_EQ(wheel.wrong, 1) << "0.6 N m do not";
  EXPECT_NEAR(friction_torque(wheel.joints[1]), -0.6, 1e-12) << "it held all the same";
  (void)wheel.step(0, 0.3, 0, 0, 0, Loads::of_last_step);
  EXPECT_EQ(wheel.wrong, 0);
  EXPECT_NEAR(friction_torque(wheel.joints[1]), -0.2, 1e-12);
  wheel.joints[1].load = -0.14;  // 0.16 N m: 0.04 less than F, a fifth of it
  EXPECT_EQ(wrong_decisions<double>(wheel.joints), 0);
  wheel.joints[1].load = -0.16;
  EXPECT_EQ(wrong_decisions<double>(wheel.joints), 1);
}

}  // namespace
}  // namespace murosimf::multibody
