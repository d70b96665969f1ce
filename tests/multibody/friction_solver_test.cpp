// Joints with dry friction: eight robots in lanes stick as one does, bit for bit.
#include "murosimf/multibody/friction_solver.h"

#include <gtest/gtest.h>

#include "murosimf/math/pack.h"
#include "murosimf/model/model.h"
#include "murosimf/model/properties.h"
#include "murosimf/multibody/kinematics.h"
#include "murosimf/multibody/servo_motor.h"
#include "tests/fixtures.h"
#include "tests/law.h"
#include "tests/physics/friction_sets.h"

namespace murosimf::multibody {
namespace {

using fixtures::same_bits;
using fixtures::State;

constexpr double h = 1e-3;
const Vec3d gravity{0, 0, -9.81};

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
      const MotorTorque<S> torque = motor_torque(motor, input, h);
      const double viscous = servo.friction.viscous;
      joints[l].gear = &servo.friction;
      joints[l].rate = state.qd[i];
      joints[l].motor_torque = torque.now;
      joints[l].torque = torque.torque - viscous * state.qd[i];
      joints[l].inertia = torque.inertia + servo.rotor_inertia + h * viscous;
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

}  // namespace
}  // namespace murosimf::multibody
