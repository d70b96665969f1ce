// A robot as one rigid body: its accelerations under loads and dampings of its bodies, joints that move its base or its
// center, what an island solver asks, both integrators.
#include "murosimf/dynamics/simplified_dynamics.h"

#include <gtest/gtest.h>

#include "murosimf/collision/contact_properties.h"
#include "murosimf/dynamics/motion_properties.h"
#include "tests/fixtures.h"
#include "tests/physics/mechanics.h"
#include "tests/physics/rig.h"

namespace murosimf::dynamics {
namespace {

using fixtures::difference;
using test::Rig;

constexpr double dt = 1e-3;

/// A trunk whose center is beside its origin, a heavy arm that swings about y, and a slider across.
ModelPtr lopsided() {
  return std::make_shared<const Model>("lopsided",
                                       Chain{}
                                           .base("trunk")
                                           .with(properties::mass, 2.0)
                                           .with(properties::center_of_mass, {0.02, -0.03, 0.05})
                                           .with(properties::inertia, {0.02, 0.03, 0.015, 1e-3, -2e-3, 5e-4})
                                           .translation({0.1, 0.05, 0.2})
                                           .revolute("arm", {0, 1, 0})
                                           .with(properties::mass, 0.8)
                                           .with(properties::center_of_mass, {0.15, 0.01, 0})
                                           .with(properties::inertia, {1e-3, 4e-3, 4e-3, 0, 0, 0})
                                           .with(properties::joint_range, {-0.5, 1.0})
                                           .translation({0.3, 0, 0})
                                           .prismatic("slider", {0, 1, 0})
                                           .with(properties::mass, 0.3)
                                           .with(properties::inertia, diagonal(5e-4)));
}

/// In empty space, turned, with its arm bent.
struct Flying {
  explicit Flying(const SimplifiedDynamicsOptions& options = {}, const Vec3d& gravity = {}, double rate_hz = 1000)
      : rig(0.8, 0, rate_hz) {
    rig.simulation.world().gravity = gravity;
    robot = &rig.add("robot", lopsided(), {.position = {1, 2, 3}, .heading = 0.5, .attitude = rotation_x(0.7)});
    rig.simulation.attach<SimplifiedDynamics>("simplified_dynamics", *robot, rate_hz, options);
    rig.simulation.initialize();
  }
  template <class T>
  [[nodiscard]] T of(const Property<T>& property) {
    return robot->base().get(property);
  }
  template <class T>
  T& at(const char* object, const Property<T>& property) {
    return robot->column(property).values[robot->model().object_index(object)];
  }
  [[nodiscard]] Vec3d center() { return of(properties::common_center_of_mass); }
  [[nodiscard]] Vec3d velocity() { return of(properties::common_center_of_mass_velocity); }
  [[nodiscard]] Vec3d turning() { return of(properties::angular_velocity); }
  [[nodiscard]] SymMat3d inertia() { return of(properties::common_inertia); }
  void step(int steps = 1) {
    for (int i = 0; i < steps; ++i) rig.simulation.step();
  }
  Rig rig;
  Entity* robot = nullptr;
};

const Vec3d v0{0.4, -0.2, 0.3}, w0{3, -2, 1};

// Both parts of the Newton-Euler equations, semi-implicit, with loads on several bodies.
TEST(SimplifiedDynamics, LoadsAccelerateTheWholeAsOneBody) {
  Flying flying({}, {0.3, 0.2, -9.81});
  const double mass = flying.of(properties::total_mass);
  EXPECT_NEAR(mass, 3.1, 1e-12);
  Rig::launch(*flying.robot, v0, w0);
  const Wrenchd of_trunk{{0.1, 0.2, -0.3}, {4, -5, 6}}, of_slider{{0, 0.4, 0}, {-1, 7, 2}};
  flying.at("trunk", properties::external_force) = of_trunk;
  flying.at("slider", properties::external_force) = of_slider;
  const Vec3d c = flying.center();
  const SymMat3d I = flying.inertia();
  const Mat3d R = flying.of(properties::orientation);
  Vec3d moment = -cross(w0, I * w0), force = mass * Vec3d{0.3, 0.2, -9.81};
  for (const auto& [object, load] : {std::pair{"trunk", of_trunk}, {"slider", of_slider}}) {
    force += load.f;
    moment += load.n + cross(flying.at(object, properties::position) - c, load.f);
  }
  flying.step();
  const Vec3d v = v0 + (dt / mass) * force, L = I * w0 + dt * (moment + cross(w0, I * w0));
  const Vec3d middle_rate = w0 + (0.5 * dt) * (inverse(I) * moment);
  EXPECT_LT(difference(flying.velocity(), v), 1e-12);
  EXPECT_LT(difference(flying.inertia() * flying.turning(), L), 1e-12) << "of the inertia where it is now";
  EXPECT_GT(difference(flying.inertia() * w0, I * w0), 1e-6) << "another one";
  EXPECT_LT(difference(flying.center(), c + dt * v), 1e-12);
  EXPECT_LT(difference(flying.of(properties::orientation), to_matrix(exponential(dt * middle_rate)) * R), 1e-12);
  EXPECT_LT(difference(to_matrix(flying.of(properties::base_quaternion)), flying.of(properties::orientation)), 1e-12);
}

// Rule: a damping of a body is of its own velocity after the step: what it adds balances with what it takes.
TEST(SimplifiedDynamics, DampingsAreImplicit) {
  Flying flying;
  Rig::launch(*flying.robot, v0, w0);
  fixtures::Dice dice("damping");
  const Wrenchd load{dice.vector(1), dice.vector(5)};
  Sym6d damping = at_point(SymMat3d{400, 300, 200, 30, 20, 10}, dice.vector(0.2));
  damping.J += diagonal(0.5);
  flying.at("arm", properties::external_force) = load;
  flying.at("arm", properties::external_damping) = damping;
  const Vec3d c = flying.center(), arm = flying.at("arm", properties::position) - c;
  const SymMat3d I = flying.inertia();
  flying.step();
  const Vec3d dv = flying.velocity() - v0, dw = flying.turning() - w0;
  const Wrenchd felt = load - damping * Twistd{dw, dv + cross(dw, arm)};
  EXPECT_LT(difference((3.1 / dt) * dv, felt.f), 1e-9);
  EXPECT_LT(difference((1 / dt) * (I * dw) + cross(w0, I * w0), felt.n + cross(arm, felt.f)), 1e-9);
  EXPECT_GT(norm(damping.M * dv), 0.1) << "it counts";
}

// Center-continuous: limbs move the base, not the center, and never turn it.
TEST(SimplifiedDynamics, LimbsMoveTheBaseAroundTheCenter) {
  Flying flying;
  const Vec3d c = flying.center(), r = Rig::place(*flying.robot);
  const Mat3d R = flying.of(properties::orientation);
  flying.robot->object("arm").set(properties::joint_target, 0.8);
  flying.robot->object("slider").set(properties::joint_target, 0.1);
  flying.step(30);
  EXPECT_LT(difference(flying.center(), c), 1e-12);
  EXPECT_LT(difference(flying.of(properties::orientation), R), 1e-12);
  EXPECT_GT(norm(Rig::place(*flying.robot) - r), 0.01);
  EXPECT_LT(norm(test::momentum(*flying.robot).f), 1e-12) << "velocities of the bodies say so, too";
  EXPECT_GT(norm(flying.of(properties::linear_velocity)), 1e-3);
}

// The paper's literal reading: limbs move the center.
TEST(SimplifiedDynamics, BaseRigidLimbsMoveTheCenter) {
  Flying flying({.base_rigid = true});
  Rig::launch(*flying.robot, {}, {});
  const Vec3d c = flying.center(), r = Rig::place(*flying.robot);
  flying.robot->object("arm").set(properties::joint_target, 0.8);
  flying.step(300);
  EXPECT_LT(difference(Rig::place(*flying.robot), r), 1e-12);
  EXPECT_GT(norm(flying.center() - c), 0.01);
  // afterwards it is a rigid body that turns about its present center
  Rig::launch(*flying.robot, v0, w0);
  const Vec3d center = flying.center(), arm = Rig::place(*flying.robot) - center;
  const SymMat3d I = flying.inertia();
  const Mat3d R = flying.of(properties::orientation);
  flying.step();
  const Vec3d w = w0 - dt * (inverse(I) * cross(w0, I * w0));
  const Mat3d turned = to_matrix(exponential(dt * w));
  EXPECT_LT(difference(flying.turning(), w), 1e-9);
  EXPECT_LT(difference(flying.center(), center + dt * v0), 1e-8);
  EXPECT_LT(difference(flying.of(properties::orientation), turned * R), 1e-9);
  EXPECT_LT(difference(Rig::place(*flying.robot), center + dt * v0 + turned * arm), 1e-8);
  EXPECT_LT(difference(flying.of(properties::linear_velocity), v0 + cross(w, turned * arm)), 1e-7);
  EXPECT_LT(difference(flying.velocity(), v0), 1e-7);
}

// Users move the base by name: the center goes with it.
TEST(SimplifiedDynamics, TakesOverWhatUsersChange) {
  Flying flying;
  Rig::launch(*flying.robot, v0);
  flying.step();
  const Vec3d c = flying.center();
  flying.robot->base().set(properties::position, Rig::place(*flying.robot) + Vec3d{0.1, 0.2, 0.3});
  flying.robot->base().set(properties::linear_velocity, flying.of(properties::linear_velocity) + Vec3d{1, 0, -2});
  flying.step();
  const Vec3d v = v0 + Vec3d{1, 0, -2};
  EXPECT_LT(difference(flying.velocity(), v), 1e-12);
  EXPECT_LT(difference(flying.center(), c + Vec3d{0.1, 0.2, 0.3} + dt * v), 1e-12);
}

// What an island solver is told is the rigid body: J M^-1 J^T, and what impulses then do to the step.
TEST(SimplifiedDynamics, AnswersToImpulses) {
  Flying flying({}, {0, 0, -9.81});
  Rig::launch(*flying.robot, v0, w0);
  auto& interface = flying.robot->column(collision::contact_interface).values[0];
  ASSERT_NE(interface.response, nullptr);
  ASSERT_EQ(interface.response->coordinates(), 6U);
  const Vec3d c = flying.center(), point = flying.at("slider", properties::position) + Vec3d{0.02, 0.03, -0.04};
  const SymMat3d I = flying.inertia();
  ASSERT_TRUE(interface.response->free_pass(dt));
  const Vec3d arm = point - c, w_free = w0 - dt * (inverse(I) * cross(w0, I * w0));
  const Vec3d free = Vec3d{1, 2, 3} + dt * Vec3d{0, 0, -9.81} + cross(w_free - w0, arm);
  EXPECT_LT(difference(interface.response->free_velocity(0, point, {1, 2, 3}), free), 1e-12);
  const Mat3d directions = rotation_z(0.4) * rotation_x(0.9);
  collision::ResponseRows y;
  interface.response->respond(flying.robot->model().object_index("slider"), point, directions, y);
  SymMat3d W;
  for (const Vec3d& row : y.value) W += outer(row);
  const auto effect = [&](const Vec3d& f) { return (1 / 3.1) * f + cross(inverse(I) * cross(arm, f), arm); };
  EXPECT_NEAR(W.xx, dot(directions.x, effect(directions.x)), 1e-12);
  EXPECT_NEAR(W.yz, dot(directions.y, effect(directions.z)), 1e-12);
  EXPECT_NEAR(W.xy, dot(directions.y, effect(directions.x)), 1e-12);
  const Vec3d lambda{0.02, -0.03, 0.05};
  std::vector<double> z(6);
  for (std::size_t k = 0; k < y.index.size(); ++k) z[static_cast<std::size_t>(y.index[k])] += dot(y.value[k], lambda);
  interface.response->apply(z);
  flying.robot->column(collision::contacts).values[0].solved = true;
  flying.step();
  const Vec3d impulse = directions * lambda;
  EXPECT_LT(difference(flying.velocity(), v0 + dt * Vec3d{0, 0, -9.81} + (1 / 3.1) * impulse), 1e-12);
  EXPECT_LT(difference(flying.turning(), w_free + inverse(I) * cross(arm, impulse)), 1e-12);
  EXPECT_FALSE(flying.robot->column(collision::contacts).values[0].solved) << "the next step is its own again";
}

TEST(SimplifiedDynamics, AFreePassOfBadNumbersIsRefused) {
  Flying flying;
  auto* response = flying.robot->column(collision::contact_interface).values[0].response;
  flying.at("trunk", properties::external_force) = {{}, {1e7, 0, 0}};
  EXPECT_FALSE(response->free_pass(dt));
  flying.at("trunk", properties::external_force) = {};
  EXPECT_TRUE(response->free_pass(dt));
  flying.at("arm", properties::joint_target) = std::nan("");
  EXPECT_FALSE(response->free_pass(dt));
}

// Momentum at the exchange: a level with masses in every link hands over what all of them have.
TEST(SimplifiedDynamics, TakesOverTheMomentum) {
  Rig rig;
  rig.simulation.world().gravity = {};
  Entity& robot = rig.add("robot", lopsided(), {.position = {1, 2, 3}, .attitude = rotation_x(0.7)});
  rig.attach_dynamics(robot, {.level = "full_dynamics", .on_ground = false});
  rig.simulation.initialize();
  Rig::launch(robot, v0, w0);
  robot.object("arm").set(properties::joint_target, 0.8);
  rig.run(0.02);
  const Wrenchd momentum = test::momentum(robot);
  const Vec3d place = Rig::place(robot);
  rig.exchange(robot, "simplified_dynamics");
  const SymMat3d I = robot.base().get(properties::common_inertia);
  EXPECT_LT(difference(robot.base().get(properties::angular_velocity), inverse(I) * momentum.n), 1e-9);
  EXPECT_LT(difference(Rig::velocity(robot), (1 / 3.1) * momentum.f), 1e-9);
  EXPECT_LT(difference(test::momentum(robot).f, momentum.f), 1e-9) << "bodies move with it";
  EXPECT_EQ(difference(Rig::place(robot), place), 0);
  EXPECT_EQ(robot.base().get(properties::dynamic), 1);
  EXPECT_NE(robot.find(collision::contact_interface)->values[0].response, nullptr);
  const Vec3d L = I * robot.base().get(properties::angular_velocity);
  rig.exchange(robot, "full_dynamics");
  EXPECT_LT(difference(test::momentum(robot).n, L), 1e-6) << "and back, that of a rigid body";
}

TEST(SimplifiedDynamics, FreezesWithoutMotionIfItsNumbersGoBad) {
  for (const Integrator integrator : {Integrator::semi_implicit_euler, Integrator::rk4}) {
    for (const bool by_force : {true, false}) {
      Flying flying({.integrator = integrator});
      Rig::launch(*flying.robot, v0, w0);
      flying.step();
      const Vec3d place = Rig::place(*flying.robot);
      if (by_force) flying.at("trunk", properties::external_force) = {{}, {0, 1e8, 0}};
      if (!by_force) flying.at("arm", properties::joint_target) = std::nan("");
      flying.step();
      ASSERT_TRUE(flying.robot->frozen()) << by_force;
      EXPECT_TRUE(fixtures::says(*flying.robot->frozen_reason(), {by_force ? "1000 m/s" : "target"}));
      EXPECT_EQ(norm(flying.velocity()), 0);
      EXPECT_EQ(norm(flying.of(properties::linear_velocity)), 0);
      EXPECT_EQ(norm(flying.turning()), 0);
      EXPECT_EQ(flying.of(properties::dynamic), 0);
      EXPECT_LT(norm(Rig::place(*flying.robot) - place), 1e-9) << "where it was";
    }
  }
}

const SimplifiedDynamicsOptions runge_kutta{.integrator = Integrator::rk4};

// Closed forms: a parabola, and angular momentum that stays. Tolerance: the fourth order of 1 ms.
TEST(SimplifiedDynamicsRk4, FallsAndTumbles) {
  Flying flying(runge_kutta, {0.3, 0.2, -9.81});
  Rig::launch(*flying.robot, v0, w0);
  const Vec3d c = flying.center(), L = flying.inertia() * w0;
  const double energy = 0.5 * dot(w0, L);
  flying.step(200);
  const Vec3d gravity{0.3, 0.2, -9.81};
  EXPECT_LT(difference(flying.center(), c + 0.2 * v0 + 0.02 * gravity), 1e-12);
  EXPECT_LT(difference(flying.velocity(), v0 + 0.2 * gravity), 1e-12);
  EXPECT_LT(difference(flying.inertia() * flying.turning(), L), 1e-9);
  EXPECT_NEAR(0.5 * dot(flying.turning(), L), energy, 1e-9);
  EXPECT_GT(norm(flying.turning() - w0), 0.1);
}

// A load at a body that turns away below it, and a base that users move: half as long steps give the same.
TEST(SimplifiedDynamicsRk4, IsOfAHighOrder) {
  const auto end = [](double rate_hz) {
    Flying flying(runge_kutta, {}, rate_hz);
    Rig::launch(*flying.robot, v0, w0);
    flying.at("slider", properties::external_force) = {{0.1, 0, 0}, {0, 2, 1}};
    flying.rig.run(0.1);
    flying.robot->base().set(properties::position, Rig::place(*flying.robot) + Vec3d{0.1, 0, 0});
    flying.rig.run(0.1);
    return std::tuple{flying.center(), flying.velocity(), flying.turning()};
  };
  const auto [c, v, w] = end(1000);
  const auto [c_half, v_half, w_half] = end(2000);
  EXPECT_LT(difference(c, c_half), 1e-9);
  EXPECT_LT(difference(v, v_half), 1e-9);
  EXPECT_LT(difference(w, w_half), 1e-8);
  // and it is the same motion as that of the other integrator, which is of first order
  Flying euler({}, {}, 10000);
  Rig::launch(*euler.robot, v0, w0);
  euler.at("slider", properties::external_force) = {{0.1, 0, 0}, {0, 2, 1}};
  euler.rig.run(0.1);
  euler.robot->base().set(properties::position, Rig::place(*euler.robot) + Vec3d{0.1, 0, 0});
  euler.rig.run(0.1);
  EXPECT_LT(difference(c, euler.center()), 1e-3);
  EXPECT_LT(difference(w, euler.turning()), 1e-2);
}

// The filter's closed form, q = target (1 - (1 + wf t) exp(-wf t)), and the end of the range.
TEST(SimplifiedDynamicsRk4, JointsFollowTheirFilter) {
  Flying flying(runge_kutta);
  const Vec3d c = flying.center();
  flying.robot->object("slider").set(properties::joint_target, 0.1);
  flying.robot->object("arm").set(properties::joint_target, 2.0);
  flying.step(20);
  const double t = 120 * 0.02;
  EXPECT_NEAR(flying.at("slider", properties::joint_position), 0.1 * (1 - (1 + t) * std::exp(-t)), 1e-6);
  flying.step(200);
  EXPECT_NEAR(flying.at("arm", properties::joint_position), 1.0, 1e-9);
  flying.robot->object("arm").set(properties::joint_velocity, 20);
  flying.step();
  EXPECT_EQ(flying.at("arm", properties::joint_position), 1.0);
  EXPECT_EQ(flying.at("arm", properties::joint_velocity), 0);
  EXPECT_LT(difference(flying.center(), c), 1e-12);
}

}  // namespace
}  // namespace murosimf::dynamics
