// Joints with dry friction: eight robots in lanes stick as one does, bit for bit.
#include <algorithm>

#include "murosimf/multibody/friction_solver.h"

#include <gtest/gtest.h>

#include "murosimf/math/pack.h"
#include "murosimf/model/model.h"
#include "murosimf/model/properties.h"
#include "murosimf/multibody/inverse_dynamics.h"
#include "murosimf/multibody/kinematics.h"
#include "murosimf/multibody/servo/servo_motor.h"
#include "tests/fixtures.h"
#include "tests/law.h"
#include "tests/physics/friction_sets.h"

namespace murosimf::multibody {
namespace {

using fixtures::same_bits;
using fixtures::State;

constexpr double h = 1e-3;

/// Two links that move in one plane below a bolted ceiling.
Model two_links() {
  Chain chain;
  chain.base("ceiling");
  for (const char* name : {"upper", "lower"}) {
    chain.revolute(name, {0, 1, 0})
        .with(properties::mass, 0.2)
        .with(properties::center_of_mass, {0, 0, -0.05})
        .with(properties::inertia, diagonal(1e-4));
    chain.translation({0, 0, -0.1});
  }
  return Model("arms", std::move(chain));
}

/// One robot, or eight.
template <class S>
struct Arms {
  Arms(const Model& model, const Servo& its_servo)
      : tree(model.tree()),
        servo(its_servo),
        motor(servo),
        state(model.size()),
        links(tree.links.size()),
        bodies(tree.links.size()),
        joints(tree.links.size()),
        target(tree.links.size()) {
    state.R[0] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  }

  void place() {
    poses<S>(tree, state.q, state.r, state.R);
    link_motions<S>(tree, state.r, state.R, state.w[0], state.qd, links);
  }
  void drive() {
    for (std::size_t l = 1; l < links.size(); ++l) {
      const int i = tree.links[l].object;
      const MotorInput<S> input{.target = target[l], .q = state.q[i], .rate = state.qd[i]};
      const double viscous = servo.friction.viscous;
      joints[l].gear = &servo.friction;
      joints[l].rate = state.qd[i];
      joints[l].motor = motor_torque(motor, input, h);
      joints[l].torque = -viscous * state.qd[i];
      joints[l].inertia = servo.rotor_inertia + h * viscous;
    }
  }
  S pass(Loads loads) {
    clear_loads<S>(bodies);
    sweep_with_friction<S>(tree, links, bodies, joints, loads, h);
    return accelerate_with_friction<S>(tree, links, bodies, joints, Twist<S>{{}, {0.0, 0.0, 9.81}});
  }
  /// Lanes that are settled keep what they have: a robot alone makes no further pass.
  void step() {
    place();
    drive();
    S wrong = pass(Loads::of_last_pass);
    for (int again = 1; again < 6 && any(wrong > S(0.0)); ++again) {
      const std::vector<ArticulatedLink<S>> settled = bodies;
      const std::vector<FrictionalJoint<S>> decided = joints;
      const S next = pass(Loads::of_repeated_pass);
      for (std::size_t l = 0; l < links.size(); ++l) {
        const auto choose = [&](const S& old, S& now) { now = select(wrong > S(0.0), now, old); };
        choose(settled[l].joint_acceleration, bodies[l].joint_acceleration);
        choose(settled[l].acceleration.w.y, bodies[l].acceleration.w.y);
        choose(settled[l].acceleration.v.x, bodies[l].acceleration.v.x);
        choose(settled[l].acceleration.v.z, bodies[l].acceleration.v.z);
        choose(decided[l].direction, joints[l].direction);
      }
      wrong = select(wrong > S(0.0), next, wrong);
    }
    for (std::size_t l = 1; l < links.size(); ++l) {
      const int i = tree.links[l].object;
      const S rate = state.qd[i] + h * bodies[l].joint_acceleration;
      state.qd[i] = select(joints[l].direction == S(0.0), S(0.0), rate);
      state.q[i] = state.q[i] + h * state.qd[i];
    }
  }

  const Tree& tree;
  Servo servo;
  ServoMotor motor;
  State<S> state;
  std::vector<LinkMotion<S>> links;
  std::vector<ArticulatedLink<S>> bodies;
  std::vector<FrictionalJoint<S>> joints;
  std::vector<S> target;
};

double start_angle(int lane, std::size_t link) { return 0.1 * lane - 0.3 + 0.2 * static_cast<double>(link); }
double target_angle(int lane, std::size_t link) { return 0.25 * static_cast<double>(link) - 0.05 * lane; }

class Lanes : public testing::TestWithParam<test::FrictionSet> {};
INSTANTIATE_TEST_SUITE_P(FrictionalJoints, Lanes, testing::ValuesIn(test::friction_sets()),
                         [](const auto& set) { return set.param.name; });

TEST_P(Lanes, StickAsRobotsAloneDo) {
  const Model model = two_links();
  Arms<Pack8> eight(model, GetParam().servo);
  std::vector<Arms<double>> alone(8, Arms<double>(model, GetParam().servo));
  for (std::size_t l = 1; l < eight.links.size(); ++l) {
    const int i = eight.tree.links[l].object;
    for (int lane = 0; lane < 8; ++lane) {
      eight.state.q[i].set_lane(lane, alone[lane].state.q[i] = start_angle(lane, l));
      eight.target[l].set_lane(lane, alone[lane].target[l] = target_angle(lane, l));
    }
  }
  const auto step_all = [&](int steps) {
    for (int k = 0; k < steps; ++k) {
      eight.step();
      for (auto& robot : alone) robot.step();
    }
  };
  step_all(3000);
  const State<Pack8> rest = eight.state;
  step_all(3000);
  law::Worst moved;
  for (std::size_t l = 1; l < eight.links.size(); ++l) {
    const int i = eight.tree.links[l].object;
    for (int lane = 0; lane < 8; ++lane) {
      EXPECT_TRUE(same_bits(eight.state.q[i].lane(lane), alone[lane].state.q[i])) << "lane " << lane << " link " << l;
      moved.see(std::abs(eight.state.q[i].lane(lane) - rest.q[i].lane(lane)), "lane", lane, "link", l);
    }
  }
  law::expect_equal({.law = "two loaded joints in lanes, held by friction: motion in 3 s",
                     .level = "multibody kernels, " + GetParam().name,
                     .source = "what sticks does not move"},
                    moved, 0, "rad");
}

/// A random tree with torques at its joints, whose base moves as given, with or without friction.
struct Random {
  explicit Random(std::uint64_t seed)
      : model(fixtures::random_model(seed)),
        tree(model.tree()),
        dice("friction of trees", seed),
        state(fixtures::random_state(model, dice)),
        links(tree.links.size()),
        bodies(links.size()),
        joints(links.size()),
        base{dice.vector(3), dice.vector(10)} {
    poses<double>(tree, state.q, state.r, state.R);
    link_motions<double>(tree, state.r, state.R, state.w[0], state.qd, links);
    clear_loads<double>(bodies);
    for (std::size_t l = 1; l < links.size(); ++l) {
      bodies[l].torque = joints[l].torque = dice.uniform(-5, 5);
      bodies[l].added_inertia = joints[l].inertia = dice.uniform(0.001, 0.02);
      joints[l].rate = state.qd[tree.links[l].object];
    }
  }
  double with_friction(Loads loads) {
    sweep_with_friction<double>(tree, links, bodies, joints, loads, h);
    return accelerate_with_friction<double>(tree, links, bodies, joints, base);
  }
  Model model;
  const Tree& tree;
  fixtures::Dice dice;
  State<double> state;
  std::vector<LinkMotion<double>> links;
  std::vector<ArticulatedLink<double>> bodies;
  std::vector<FrictionalJoint<double>> joints;
  Twistd base;
};

// Without friction nothing is left of it, in whatever pass. Tolerance: rounding of accelerations up to 1e4 rad/s^2.
TEST(FrictionSolver, WithoutFrictionItIsTheArticulatedBodyAlgorithm) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random plain(seed);
    sweep_to_base<double>(plain.tree, plain.links, plain.bodies);
    accelerate<double>(plain.tree, plain.links, plain.bodies, plain.base);
    for (const Loads loads : {Loads::of_last_pass, Loads::of_repeated_pass, Loads::of_last_step}) {
      Random tree(seed);
      EXPECT_EQ(tree.with_friction(loads), 0);
      for (std::size_t l = 1; l < tree.links.size(); ++l) {
        const double expected = plain.bodies[l].joint_acceleration;
        EXPECT_NEAR(tree.bodies[l].joint_acceleration, expected, 1e-9 * (1 + std::abs(expected))) << seed << ' ' << l;
      }
      EXPECT_LT(fixtures::difference(tree.bodies[0].force.f, plain.bodies[0].force.f), 1e-8) << seed;
      EXPECT_LT(fixtures::difference(tree.bodies[0].force.n, plain.bodies[0].force.n), 1e-8) << seed;
    }
  }
}

// Joints that nothing can move stop within the step, each from its own rate, and pass on what their links weigh.
TEST(FrictionSolver, StuckJointsStopWithinTheStep) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random tree(seed);
    for (std::size_t l = 1; l < tree.links.size(); ++l) tree.joints[l].coulomb = 1e9;
    EXPECT_EQ(tree.with_friction(Loads::of_last_pass), 0);
    std::vector<double> qdd(tree.links.size());
    for (std::size_t l = 1; l < tree.links.size(); ++l) {
      qdd[l] = -tree.joints[l].rate / h;
      EXPECT_NEAR(tree.bodies[l].joint_acceleration, qdd[l], 1e-9 * (1 + std::abs(qdd[l]))) << seed << ' ' << l;
      EXPECT_EQ(tree.joints[l].direction, 0);
    }
    std::vector<Twistd> working(tree.links.size());
    const Wrenchd bias = base_bias<double>(tree.tree, tree.links, qdd, working);
    const double scale = 1 + norm(bias.f) + norm(bias.n);
    EXPECT_LT(fixtures::difference(tree.bodies[0].force.f, bias.f), 1e-9 * scale) << seed;
    EXPECT_LT(fixtures::difference(tree.bodies[0].force.n, bias.n), 1e-9 * scale) << seed;
  }
}

// A joint alone that slides slower than 1 mrad/s at the end of the step feels a damper of F over that rate.
TEST(FrictionSolver, SlowSlidingIsDamped) {
  const Model model("wheel", Chain{}
                                 .base("wall")
                                 .revolute("axle", {0, 1, 0})
                                 .with(properties::mass, 3.0)
                                 .with(properties::inertia, diagonal(0.02)));
  constexpr double F = 0.2, D = 0.02;
  for (const double end : {0.2e-3, -0.9e-3, 1.1e-3, -5e-3}) {  // [rad/s] where plain friction would leave it
    State<double> state(model.size());
    state.R[0] = Mat3d{};
    std::vector<LinkMotion<double>> links(2);
    std::vector<ArticulatedLink<double>> bodies(2);
    std::vector<FrictionalJoint<double>> joints(2);
    poses<double>(model.tree(), state.q, state.r, state.R);
    link_motions<double>(model.tree(), state.r, state.R, state.w[0], state.qd, links);
    joints[1].coulomb = F;
    joints[1].torque = std::copysign(F, end) + D * end / h;
    sweep_with_friction<double>(model.tree(), links, bodies, joints, Loads::of_last_step, h);
    (void)accelerate_with_friction<double>(model.tree(), links, bodies, joints, {});
    const double damping = F / std::max(std::abs(end), 1e-3);
    EXPECT_NEAR(h * bodies[1].joint_acceleration, h * joints[1].torque / (D + h * damping), 1e-12) << end;
  }
}

}  // namespace
}  // namespace murosimf::multibody
