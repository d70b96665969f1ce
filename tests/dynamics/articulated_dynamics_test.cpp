// Levels as island solvers see them: what impulses at a body do, against the same impulses as forces; explicit friction.
#include "murosimf/dynamics/articulated_dynamics.h"
#include "murosimf/collision/contact_interface.h"

#include <gtest/gtest.h>

#include "murosimf/collision/contact_laws/impulse_response.h"
#include "murosimf/collision/contact_properties.h"
#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/multibody/servo/gear_friction.h"
#include "tests/fixtures.h"
#include "tests/physics/bolted.h"
#include "tests/physics/rig.h"

namespace murosimf::dynamics {
namespace {

using fixtures::difference;
using test::Rig;

constexpr double h = 1e-3;

/// A body on which an impulse acts.
struct Place {
  const char* object;
  Vec3d offset;  // [m] of the point, own axes
};
const std::vector<Place> places{{"trunk", {0.1, -0.02, 0.05}},
                                {"left_foot", {0.05, 0.02, -0.01}},
                                {"right_knee", {0, 0.03, -0.1}}};

/// A robot that flies, turns and bends, with a servo in one of its joints.
struct Flying {
  explicit Flying(const std::string& level, const MovingTreeOptions& tree = {}) {
    rig.simulation.world().gravity = {0.5, -1, -9};
    robot = &rig.add("robot", std::make_shared<const Model>(fixtures::two_legged()),
                     {.position = {1, 2, 3}, .attitude = to_matrix(exponential(Vec3d{0.4, -0.3, 0.6}))});
    rig.attach_dynamics(*robot, {.level = level, .on_ground = false, .tree = tree});
    rig.simulation.initialize();
    Rig::launch(*robot, {1, -2, 0.5}, {1, -2, 3});
    double angle = 0.1;
    for (const int joint : robot->model().joints()) {
      const auto access = robot->object(robot->model().objects()[joint].name);
      ObjectAccess(access).set(properties::joint_position, angle);
      ObjectAccess(access).set(properties::joint_velocity, 3 * angle);
      ObjectAccess(access).set(properties::joint_target, -angle);
      angle += 0.13;
    }
    // so that all columns are those of this pose
    rig.simulation.step();
    response = robot->find(collision::contact_interface)->values[0].response;
  }
  [[nodiscard]] int object(const Place& place) const { return robot->model().object_index(place.object); }
  [[nodiscard]] Vec3d point(const Place& place) {
    const auto body = robot->object(place.object);
    return body.get(properties::position) + body.get(properties::orientation) * place.offset;
  }
  /// [m/s] of a point now.
  [[nodiscard]] Vec3d velocity(const Place& place) {
    const auto body = robot->object(place.object);
    return body.get(properties::linear_velocity) +
           cross(body.get(properties::angular_velocity), point(place) - body.get(properties::position));
  }
  [[nodiscard]] Vec3d free_velocity(const Place& place) {
    return response->free_velocity(object(place), point(place), velocity(place));
  }
  /// The numbers y of three directions, one row for each number of z.
  [[nodiscard]] std::vector<Vec3d> rows(const Place& place, const Mat3d& directions) {
    collision::ResponseRows sparse;
    response->respond(object(place), point(place), directions, sparse);
    std::vector<Vec3d> dense(response->coordinates());
    for (std::size_t k = 0; k < sparse.index.size(); ++k)
      dense[static_cast<std::size_t>(sparse.index[k])] += sparse.value[k];
    return dense;
  }
  Rig rig;
  Entity* robot = nullptr;
  collision::ImpulseResponse* response = nullptr;
};

class Response : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Levels, Response, testing::ValuesIn(test::dynamic_levels()), test::level_name);

const Mat3d directions = rotation_z(0.4) * rotation_x(1.1);
const Vec3d impulse{0.02, -0.05, 0.03};  // [N s] along them

// v = v_free + y . z: at the same point and at all others, before and after the impulse has been applied.
TEST_P(Response, ImpulsesChangeVelocitiesAsTheirNumbersSay) {
  for (const Place& pushed : places) {
    Flying flying(GetParam());
    ASSERT_TRUE(flying.response->free_pass(h));
    std::vector<double> z;
    for (const Vec3d& row : flying.rows(pushed, directions)) z.push_back(dot(row, impulse));
    std::vector<Vec3d> expected;
    for (const Place& seen : places) {
      Vec3d change;
      const auto rows = flying.rows(seen, directions);
      for (std::size_t k = 0; k < z.size(); ++k) change += z[k] * rows[k];
      expected.push_back(flying.free_velocity(seen) + directions * change);
    }
    flying.response->apply(z);
    for (std::size_t i = 0; i < places.size(); ++i) {
      EXPECT_LT(difference(flying.free_velocity(places[i]), expected[i]), 1e-10) << pushed.object << places[i].object;
    }
  }
}

// The same impulse as a force during the step, in a robot of its own.
TEST_P(Response, ImpulsesDoWhatForcesDo) {
  for (const Place& pushed : places) {
    Flying flying(GetParam()), other(GetParam());
    ASSERT_TRUE(flying.response->free_pass(h));
    std::vector<double> z;
    for (const Vec3d& row : flying.rows(pushed, directions)) z.push_back(dot(row, impulse));
    flying.response->apply(z);
    const Vec3d force = (1 / h) * (directions * impulse);
    const auto i = static_cast<std::size_t>(other.object(pushed));
    auto& forces = other.robot->column(properties::external_force).values;
    const Vec3d arm = other.point(pushed) - other.robot->object(pushed.object).get(properties::position);
    forces[i] += Wrenchd{cross(arm, force), force};
    ASSERT_TRUE(other.response->free_pass(h));
    for (const Place& seen : places) {
      EXPECT_LT(difference(flying.free_velocity(seen), other.free_velocity(seen)), 1e-9)
          << pushed.object << seen.object;
    }
  }
}

// What the free pass says of a point is its velocity after the next step, but for what its arms turn in a step; the joints of
// full_dynamics follow their targets with some 1000 rad/s^2. (simplified_dynamics is a rigid body whose limbs move.)
TEST_P(Response, FreeVelocityIsThatOfTheNextStep) {
  if (GetParam() == "simplified_dynamics") GTEST_SKIP() << "its limbs do not count";
  for (const Place& place : places) {
    Flying flying(GetParam()), other(GetParam());
    ASSERT_TRUE(flying.response->free_pass(h));
    const Vec3d predicted = flying.free_velocity(place);
    other.rig.simulation.step();
    EXPECT_LT(norm(predicted - other.velocity(place)), GetParam() == "full_dynamics" ? 0.25 : 0.05) << place.object;
  }
}

// A body whose force falls with its velocity, f = F - b (v+ - v): as one that feels just this f.
TEST_P(Response, DampedForceIsTheForceThatItComesTo) {
  constexpr double b = 40;  // [N s/m]
  const Vec3d F{3, -8, 5};
  for (const char* object : {"trunk", "left_foot", "right_knee"}) {
    const Place origin{object, {}};
    Flying damped(GetParam()), other(GetParam());
    const auto i = static_cast<std::size_t>(damped.object(origin));
    Sym6d damping;
    damping.M = diagonal(b);
    damped.robot->column(properties::external_force).values[i] = {{}, F};
    damped.robot->column(properties::external_damping).values[i] = damping;
    const Vec3d before = damped.velocity(origin);
    ASSERT_TRUE(damped.response->free_pass(h));
    const Vec3d force = F - b * (damped.free_velocity(origin) - before);
    EXPECT_GT(norm(force - F), 0.1) << object;
    other.robot->column(properties::external_force).values[i] = {{}, force};
    ASSERT_TRUE(other.response->free_pass(h));
    for (const Place& seen : places) {
      EXPECT_LT(difference(damped.free_velocity(seen), other.free_velocity(seen)), 1e-9) << object << seen.object;
    }
  }
}

TEST_P(Response, NumbersThatHaveGoneBadAreNoMembers) {
  Flying good(GetParam()), target(GetParam()), force(GetParam());
  EXPECT_TRUE(good.response->free_pass(h));
  target.robot->object("left_knee").set(properties::joint_target, std::nan(""));
  EXPECT_FALSE(target.response->free_pass(h));
  force.robot->column(properties::external_force).values[0] = Wrenchd{{}, {1e8, 0, 0}};
  EXPECT_FALSE(force.response->free_pass(h));
}

TEST_P(Response, BoltedBaseDoesNotAnswer) {
  if (GetParam() == "simplified_dynamics") GTEST_SKIP() << "it has no bolted base";
  Flying flying(GetParam(), {.fixed_base = true});
  ASSERT_TRUE(flying.response->free_pass(h));
  for (const Vec3d& row : flying.rows(places[0], directions)) EXPECT_EQ(norm(row), 0);
  EXPECT_LT(norm(flying.free_velocity(places[0])), 1e-12);
}

// Limits of the sums over all joints: 1e4 rad/s and 1e4 rad, whatever the signs.
TEST(ArticulatedSanity, JointsMayBeFastAndFarUpToALimit) {
  const auto frozen = [](double q, double qd) {
    Chain chain = Chain{}.base("wall");
    for (const char* name : {"joint", "other"}) {
      chain.revolute(name, {0, 0, 1}).with(properties::mass, 1.0).with(properties::inertia, diagonal(0.02));
    }
    test::Bolted robot(chain);
    robot.joint("joint").set(properties::joint_position, 1.5 * q);
    robot.joint("other").set(properties::joint_position, -0.5 * q);
    robot.joint("joint").set(properties::joint_velocity, -0.7 * qd);
    robot.joint("other").set(properties::joint_velocity, 0.3 * qd);
    robot.rig.simulation.step();
    return robot.robot->frozen();
  };
  EXPECT_FALSE(frozen(4999.7, 0));
  EXPECT_TRUE(frozen(5000.3, 0));
  EXPECT_FALSE(frozen(0, 9999.5));
  EXPECT_TRUE(frozen(0, -10000.5));
  EXPECT_TRUE(frozen(std::nan(""), 0));
}

/// A hinge with a geared servo that wants nothing, about an axis without weight.
Chain braked_wheel(const GearFriction& gear, double coulomb) {
  return Chain{}
      .base("wall")
      .revolute("joint", {0, 0, 1})
      .with(properties::mass, 1.0)
      .with(properties::inertia, diagonal(0.02))
      .with(properties::joint_friction, coulomb)
      .with(properties::servo, {.law = "ideal_pd", .position_gain = 1e-9, .friction = gear});
}

// Friction of an explicit step takes F / J off the rate in every second, whatever the direction; below 0.05 rad/s it
// is a damper of F / 0.05.
TEST(ExplicitFriction, TakesItsBudgetOffTheRate) {
  const GearFriction gear{.coulomb = 0.03};
  for (const double side : {1.0, -1.0}) {
    test::Bolted wheel(braked_wheel(gear, 0.01), Integrator::rk4);
    auto joint = wheel.joint("joint");
    joint.set(properties::joint_velocity, 1.2 * side);
    for (int i = 1; i <= 500; ++i) {
      wheel.rig.simulation.step();
      EXPECT_NEAR(joint.get(properties::joint_velocity), side * (1.2 - 0.04 / 0.02 * 1e-3 * i), 1e-7);
      EXPECT_NEAR(joint.get(properties::joint_torque), -0.03 * side, 1e-6) << "of motor and gear";
    }
    joint.set(properties::joint_velocity, 0.04 * side);
    wheel.rig.run(0.02);
    EXPECT_NEAR(joint.get(properties::joint_velocity), 0.04 * side * std::exp(-0.04 / 0.05 / 0.02 * 0.02), 1e-7);
  }
}

// An arm level with gravity: friction that depends on the load of the step before, F = 0.3 |m g l cos q|.
TEST(ExplicitFriction, DependsOnTheLoad) {
  const GearFriction gear{.external_load = 0.3};
  const double m = 1.5, l = 0.2, J = m * l * l;
  test::Bolted arm(Chain{}
                       .base("wall")
                       .revolute("joint", {0, 1, 0})
                       .with(properties::mass, m)
                       .with(properties::center_of_mass, {l, 0, 0})
                       .with(properties::inertia, diagonal(1e-9))
                       .with(properties::servo, {.law = "ideal_pd", .position_gain = 1e-9, .friction = gear}),
                   Integrator::rk4);
  auto joint = arm.joint("joint");
  joint.set(properties::joint_velocity, 1);
  arm.rig.run(0.1);
  const double before = joint.get(properties::joint_velocity), q = joint.get(properties::joint_position);
  arm.rig.simulation.step();
  const double weight = m * test::g * l * std::cos(q);
  EXPECT_NEAR(joint.get(properties::joint_velocity) - before, 1e-3 * (1 - 0.3) * weight / J, 1e-4 * weight / J * 1e-1);
  EXPECT_NEAR(joint.get(properties::joint_load), weight, 0.02 * weight);
}

// Rule: the load that friction expects is state, in a column. Runge-Kutta meets it in the first of its stages, whose weight
// is 1/6: there friction is larger by a share of 0.3 of 2 N m.
TEST(ArticulatedRungeKutta, FrictionExpectsTheLoadOfTheColumn) {
  constexpr double inertia = 0.01 + 0.5 * 0.1 * 0.1;
  const auto rate_after = [](double load) {
    Chain chain = Chain{}.base("wall").with(properties::mass, 1.0).with(properties::inertia, diagonal(0.1));
    chain.revolute("joint", {0, 1, 0})
        .with(properties::mass, 0.5)
        .with(properties::center_of_mass, {0.1, 0, 0})
        .with(properties::inertia, diagonal(0.01))
        .with(properties::servo,
              {.law = "ideal_pd", .position_gain = 5, .friction = {.coulomb = 0.02, .external_load = 0.3}});
    Simulation simulation;
    Entity& robot = simulation.world().add("arm", std::make_shared<const Model>("arm", chain));
    simulation.attach<ArticulatedDynamics>("articulated_dynamics", robot, 1000,
                                           MovingTreeOptions{.integrator = Integrator::rk4, .fixed_base = true});
    simulation.initialize();
    robot.object("joint").set(properties::joint_velocity, 2);
    robot.object("joint").set(properties::joint_load, load);
    simulation.step();
    return robot.object("joint").get(properties::joint_velocity);
  };
  const double expected = 1e-3 / 6 * 0.3 * 2 / inertia;
  EXPECT_NEAR(rate_after(0) - rate_after(2), expected, 0.02 * expected);
}

}  // namespace
}  // namespace murosimf::dynamics
