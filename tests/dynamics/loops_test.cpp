// Linkages: loops that two frames in one place close, at levels with forces and at those where motion is given.
#include <cmath>

#include <gtest/gtest.h>

#include "murosimf/collision/contact_interface.h"
#include "murosimf/collision/contact_laws/impulse_response.h"
#include "murosimf/collision/contact_properties.h"
#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/math/quaternion.h"
#include "murosimf/multibody/loop_joints.h"
#include "tests/dynamics/four_bar.h"
#include "tests/fixtures.h"
#include "tests/physics/bolted.h"
#include "tests/physics/mechanics.h"

namespace murosimf::dynamics {
namespace {

using namespace test;

// Closed form: the angle of a four-bar's rocker follows from that of its crank. Falls and swings from rest for 3 s.
TEST(Loops, SwingingFourBarKeepsItsAnglesAndItsEnergy) {
  Bolted robot(four_bar());
  const double start = energy(*robot.robot);
  double lowest = 0, most_rate = 0, drift = 0, angle = 0, apart = 0;
  for (int i = 0; i < 3000; ++i) {
    robot.rig.simulation.step();
    angle = std::max(angle, rocker_error(*robot.robot));
    apart = std::max(apart, gap(*robot.robot));
    lowest = std::max(lowest, std::abs(q(*robot.robot, "crank")));
    most_rate = std::max(most_rate, std::abs(robot.joint("crank").get(properties::joint_velocity)));
    drift = std::max(drift, std::abs(energy(*robot.robot) - start));
  }
  EXPECT_GT(lowest, 1.5);
  EXPECT_GT(most_rate, 5);
  EXPECT_LT(angle, 1e-3);
  EXPECT_LT(apart, 1e-4);
  EXPECT_LT(drift, 0.02) << "of " << start;
}

// Limit: the project's own. Hinges that are parallel but for a milliradian lock no linkage.
TEST(Loops, HingesThatAreNearlyParallelDoNotLock) {
  Bolted robot(four_bar({.rocker_tilt = 1e-3}));
  Bolted parallel(four_bar());
  for (int i = 0; i < 400 && std::abs(q(*parallel.robot, "crank")) < 2; ++i) {
    robot.rig.simulation.step();
    parallel.rig.simulation.step();
    EXPECT_NEAR(q(*robot.robot, "crank"), q(*parallel.robot, "crank"), 0.01);
  }
  EXPECT_GT(std::abs(q(*robot.robot, "crank")), 1.9);
}

// A pin whose axes are held, too, and a hinge of its own behind it: the same linkage.
TEST(Loops, WeldedFramesHoldTheirAxes) {
  Bolted robot(four_bar({.welded = true}));
  double turn = 0;
  for (int i = 0; i < 1000; ++i) {
    robot.rig.simulation.step();
    const Mat3d R = transpose(robot.joint("pin").get(properties::orientation)) *
                    robot.joint("end_of_rocker").get(properties::orientation);
    turn = std::max(turn, norm(rotation_vector(from_matrix(R))));
    EXPECT_LT(rocker_error(*robot.robot), 1e-3) << i;
  }
  EXPECT_LT(turn, 1e-4);
  EXPECT_GT(std::abs(q(*robot.robot, "end")), 0.2);
}

// Virtual work: the crank's servo carries the weight of all three bars.
TEST(Loops, ServoCarriesTheWholeLinkage) {
  Bolted robot(four_bar({.servo = servo()}));
  robot.joint("crank").set(properties::joint_target, 0.4);
  robot.rig.run(3);
  const double angle = rest - q(*robot.robot, "crank");  // joint positions count down
  const double torque = -(height_energy(angle + 1e-5) - height_energy(angle - 1e-5)) / 2e-5;
  EXPECT_GT(std::abs(torque), 0.05);
  EXPECT_NEAR(robot.joint("crank").get(properties::joint_torque), torque, 1e-4);
  EXPECT_LT(rocker_error(*robot.robot), 1e-5);
}

// In free flight without gravity: whatever the loop does, its forces are inside.
TEST(Loops, PushNothingFromOutside) {
  test::Rig rig;
  rig.simulation.world().gravity = {};
  Entity& robot =
      rig.add("robot", std::make_shared<const Model>("bars", four_bar({.servo = servo()})), {.position = {0, 0, 2}});
  rig.attach_dynamics(robot, {.level = "articulated_dynamics",
                              .law = test::law_named("kelvin_voigt"),
                              .on_ground = false,
                              .tree = {.momentum_correction = false}});
  rig.simulation.initialize();
  double most = 0;
  for (int i = 0; i < 500; ++i) {
    robot.object("crank").set(properties::joint_target, std::min(1.0, 4e-3 * i));
    rig.simulation.step();
    most = std::max(most, norm(robot.object("end_of_rocker").get(properties::loop_force).f));
    EXPECT_LT(norm(test::Rig::velocity(robot)), 5e-3) << i;
  }
  EXPECT_GT(most, 1);
  EXPECT_NEAR(q(robot, "crank"), 1.0, 0.01);
}

class LoopsAtLevel : public testing::TestWithParam<std::string> {};

// Closed form, at every level: a crank that its servo moves takes the rocker along, from the first instant on.
TEST_P(LoopsAtLevel, RockerFollowsTheCrank) {
  test::Rig rig;
  rig.simulation.world().gravity = {};
  Entity& robot =
      rig.add("robot", std::make_shared<const Model>("bars", four_bar({.servo = servo()})), {.position = {0, 0, 2}});
  rig.attach_dynamics(robot, {.level = GetParam(), .law = test::law_named("kelvin_voigt"), .on_ground = false});
  robot.object("crank").set(properties::joint_target, -0.5);
  rig.simulation.initialize();
  EXPECT_EQ(q(robot, "crank"), -0.5);
  EXPECT_LT(rocker_error(robot), 1e-8);
  double way = 0, worst = 0, rates = 0, before = q(robot, "rocker");
  for (int i = 0; i < 2000; ++i) {
    robot.object("crank").set(properties::joint_target, -0.5 * std::cos(5e-3 * i));
    rig.simulation.step();
    worst = std::max(worst, rocker_error(robot));
    way = std::max(way, std::abs(q(robot, "rocker") - before));
    const double step = q(robot, "rocker") - before;
    before = q(robot, "rocker");
    rates = std::max(rates, std::abs(robot.object("rocker").get(properties::joint_velocity) - step / 1e-3));
  }
  const bool moved_by_forces = GetParam() == "articulated_dynamics";
  EXPECT_LT(worst, moved_by_forces ? 1e-4 : 1e-8);
  EXPECT_LT(rates, 0.02);
  EXPECT_GT(way, 1e-4);
}

// The other way round: the rocker takes the target, and the servo of the crank goes where that takes it.
TEST_P(LoopsAtLevel, CrankGoesWhereTheCommandedRockerTakesIt) {
  test::Rig rig;
  rig.simulation.world().gravity = {};
  Entity& robot =
      rig.add("robot", std::make_shared<const Model>("bars", four_bar({.commanded = true, .servo = servo()})),
              {.position = {0, 0, 2}});
  rig.attach_dynamics(robot, {.level = GetParam(), .law = test::law_named("kelvin_voigt"), .on_ground = false});
  robot.object("rocker").set(properties::joint_target, -0.1);
  rig.simulation.initialize();
  EXPECT_EQ(q(robot, "rocker"), -0.1);
  EXPECT_LT(rocker_error(robot), 1e-8);
  const double before = q(robot, "crank");
  robot.object("rocker").set(properties::joint_target, -0.5);
  robot.object("crank").set(properties::joint_target, 1.0);  // without effect
  rig.run(2);
  EXPECT_NEAR(q(robot, "rocker"), -0.5, 1e-3);
  EXPECT_GT(std::abs(q(robot, "crank") - before), 0.3);
  EXPECT_LT(rocker_error(robot), 1e-4);
}
INSTANTIATE_TEST_SUITE_P(Dynamic, LoopsAtLevel, testing::ValuesIn(test::dynamic_levels()), test::level_name);

/// A linkage in free fall, as island solvers see it.
struct Falling {
  Falling() {
    robot =
        &rig.add("robot", std::make_shared<const Model>("bars", four_bar({.servo = servo()})), {.position = {0, 0, 2}});
    rig.attach_dynamics(*robot,
                        {.level = "articulated_dynamics", .law = test::law_named("kelvin_voigt"), .on_ground = false});
    rig.simulation.initialize();
    robot->object("crank").set(properties::joint_target, 0.7);
    rig.run(0.05);
    response = robot->find(collision::contact_interface)->values[0].response;
  }
  [[nodiscard]] int object(const char* name) const { return robot->model().object_index(name); }
  [[nodiscard]] Vec3d point(const char* name) { return place(*robot, name); }
  [[nodiscard]] Vec3d free_velocity(const char* name) {
    return response->free_velocity(object(name), point(name), robot->object(name).get(properties::linear_velocity));
  }
  [[nodiscard]] std::vector<double> impulse(const char* name, const Vec3d& p) {
    collision::ResponseRows y;
    response->respond(object(name), point(name), rotation_z(0.0), y);
    std::vector<double> z(response->coordinates());
    for (std::size_t k = 0; k < y.index.size(); ++k) z[y.index[k]] += dot(y.value[k], p);
    return z;
  }
  test::Rig rig;
  Entity* robot = nullptr;
  collision::ImpulseResponse* response = nullptr;
};

// An impulse of an island does what the same force does that is there before the pass: the loop answers it in the same step.
TEST(Loops, AnswerImpulsesAsForces) {
  constexpr double h = 1e-3;
  const Vec3d p{0.03, 0.01, -0.05};  // [N s]
  for (const char* pushed : {"coupler", "end_of_rocker", "frame"}) {
    Falling one, other;
    ASSERT_TRUE(one.response->free_pass(h));
    const Vec3d before = one.free_velocity("pin");
    one.response->apply(one.impulse(pushed, p));
    const int object =
        other.robot->model().tree().links[other.robot->model().tree().link_of[other.object(pushed)]].object;
    const Vec3d arm = other.point(pushed) - other.robot->column(properties::position).values[object];
    other.robot->column(properties::external_force).values[object] = (1 / h) * Wrenchd{cross(arm, p), p};
    ASSERT_TRUE(other.response->free_pass(h));
    EXPECT_GT(norm(one.free_velocity("pin") - before), 0.01) << pushed;
    for (const char* seen : {"crank", "pin", "end_of_rocker", "frame"}) {
      EXPECT_LT(norm(one.free_velocity(seen) - other.free_velocity(seen)), 1e-9) << pushed << " " << seen;
    }
  }
}

TEST(Loops, MistakesAreNamed) {
  const auto error = [](const Chain& chain, Integrator integrator = Integrator::semi_implicit_euler) {
    return fixtures::error_of([&] { Bolted(chain, integrator); });
  };
  EXPECT_TRUE(fixtures::says(error(four_bar(), Integrator::rk4), {"rk4", "loops"}));
  Chain lost = Chain{}.base("frame").with(properties::mass, 1.0).with(properties::inertia, diagonal(1.0));
  lost.revolute("hinge", {0, 1, 0}).with(properties::mass, 1.0).with(properties::inertia, diagonal(1.0));
  Chain same = lost;
  lost.endpoint("end").with(properties::loop_closure, {"fram", false});
  EXPECT_TRUE(fixtures::says(error(lost), {"'fram'", "'frame'"}));
  same.endpoint("end").with(properties::loop_closure, {"hinge", false});
  Chain apart = Chain{}.base("frame").with(properties::mass, 1.0).with(properties::inertia, diagonal(1.0));
  apart.revolute("hinge", {0, 1, 0}).with(properties::mass, 1.0).with(properties::inertia, diagonal(1.0));
  apart.with(properties::loop_commanded, 1.0);
  EXPECT_TRUE(fixtures::says(error(apart), {"'hinge'", "no loop"}));
  EXPECT_TRUE(fixtures::says(error(same), {"'end'", "'hinge'", "same body"}));
}

}  // namespace
}  // namespace murosimf::dynamics
