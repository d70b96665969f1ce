// What a joint feels besides its own drive, as friction that depends on the load sees it: also with couplings and islands.
#include <gtest/gtest.h>

#include "murosimf/collision/contact.h"
#include "murosimf/collision/contact_interface.h"
#include "murosimf/collision/contact_laws/impulse_response.h"
#include "murosimf/dynamics/motion_properties.h"
#include "tests/physics/rig.h"

namespace murosimf::dynamics {
namespace {

using test::g;

constexpr double m = 0.4, l = 0.15, J = 0.003;  // [kg], [m], [kg m^2] of a finger, at its center

Servo servo() {
  return {.law = "ideal_pd", .stall_torque = 30, .position_gain = 20, .velocity_gain = 0.5, .rotor_inertia = 1e-3};
}

Chain finger(const char* name, double side) {
  return Chain{}
      .translation({0, side, 0})
      .revolute(name, {0, 1, 0})
      .with(properties::mass, m)
      .with(properties::center_of_mass, {l, 0, 0})
      .with(properties::inertia, diagonal(J));
}

struct Bolted {
  Bolted(const Chain& chain, const std::string& law, const Vec3d& position = {}, bool on_ground = false) {
    robot = &rig.add("robot", std::make_shared<const Model>("robot", chain), {.position = position});
    rig.attach_dynamics(*robot, {.level = "articulated_dynamics",
                                 .law = test::law_named(law),
                                 .on_ground = on_ground,
                                 .tree = {.fixed_base = true}});
    rig.simulation.initialize();
  }
  test::Rig rig;
  Entity* robot = nullptr;
};

// A follower without servo: it feels its own weight at its angle before the step, and not what its coupling does to it;
// the same for the leader. Both move.
TEST(JointLoad, CouplingIsADriveAndNoLoad) {
  Chain leader = finger("leader", 0.1), follower = finger("follower", -0.1);
  leader.with(properties::servo, servo());
  follower.with(properties::joint_coupling, {"leader", -1.5, 0.2});
  Bolted bolted(
      Chain{}.base("palm").with(properties::mass, 1.5).with(properties::inertia, diagonal(0.01)).fork(leader, follower),
      "kelvin_voigt");
  double fastest = 0;
  for (int i = 0; i < 500; ++i) {
    bolted.robot->object("leader").set(properties::joint_target, 0.6 * std::sin(0.02 * i));
    std::vector<double> weight;
    for (const char* name : {"leader", "follower"}) {
      weight.push_back(m * g * l * std::cos(bolted.robot->object(name).get(properties::joint_position)));
    }
    bolted.rig.simulation.step();
    EXPECT_NEAR(bolted.robot->object("leader").get(properties::joint_load), weight[0], 1e-9) << i;
    EXPECT_NEAR(bolted.robot->object("follower").get(properties::joint_load), weight[1], 1e-9) << i;
    fastest = std::max(fastest, std::abs(bolted.robot->object("follower").get(properties::joint_velocity)));
  }
  EXPECT_GT(fastest, 1);
}

/// Moment [N m] of the forces of the ground about a hinge along y at `hinge`.
double moment_of_ground(Entity& robot, const Vec3d& hinge) {
  double sum = 0;
  for (const auto& c : robot.find(collision::contacts)->values[0].points) sum += cross(c.point - hinge, c.force).y;
  return sum;
}

// An arm whose hand is pressed on the ground: the hinge feels its weight and the ground, whose force comes after the pass.
TEST(JointLoad, ContactsInsideAnIslandAreALoad) {
  PlacedShape ball;
  ball.shape = Sphere{0.03};
  ball.position = {2 * l, 0, 0};
  for (const std::string law : {"island_gauss_seidel", "implicit_stick"}) {
    Bolted bolted(Chain{}
                      .base("wall")
                      .translation({0, 0, 0.2})
                      .revolute("hinge", {0, 1, 0})
                      .with(properties::mass, m)
                      .with(properties::center_of_mass, {l, 0, 0})
                      .with(properties::inertia, diagonal(J))
                      .with(properties::servo, servo())
                      .with(properties::shapes, Shapes{ball}),
                  law, {0, 0, -1e-4}, true);
    auto hinge = bolted.robot->object("hinge");
    hinge.set(properties::joint_target, 0.4);  // into the ground
    bolted.rig.run(2);
    const double ground = moment_of_ground(*bolted.robot, hinge.get(properties::position));
    EXPECT_LT(ground, -1) << law;
    const double weight = m * g * l * std::cos(hinge.get(properties::joint_position));
    EXPECT_NEAR(hinge.get(properties::joint_load), weight + ground, 1e-4) << law;
    EXPECT_NEAR(hinge.get(properties::joint_load), -hinge.get(properties::joint_torque), 1e-4) << law;
  }
}

/// A hinge that turns with 2 rad/s, and loses a share of 0.3 of its load to friction.
struct Braked : Bolted {
  Braked()
      : Bolted(Chain{}.base("wall").fork(std::vector<Chain>{finger("hinge", 0).with(properties::servo, gear())}),
               "kelvin_voigt") {
    hinge.set(properties::joint_velocity, 2);
  }
  static Servo gear() {
    return {.law = "ideal_pd", .position_gain = 1e-9, .friction = {.coulomb = 0.02, .external_load = 0.3}};
  }
  ObjectAccess hinge = robot->object("hinge");
};
constexpr double h = 1e-3, of_axle = J + m * l * l;  // [s], [kg m^2]

// Rule: what friction expects of a step is state, in columns. Here the acceleration of the wall, from which the load follows.
TEST(JointLoad, FollowsTheAccelerationOfTheColumn) {
  const auto rate_after = [](double felt) {
    Braked braked;
    braked.robot->base().set(properties::felt_acceleration, {{}, {0, 0, felt}});
    braked.rig.simulation.step();
    return braked.hinge.get(properties::joint_velocity);
  };
  EXPECT_NEAR(rate_after(0) - rate_after(g), h * 0.3 * m * g * l / of_axle, 1e-9);
}

// The same inside an island, where the load itself is the one of the column; to first order in the change of the rate.
TEST(JointLoad, IsThatOfTheColumnInsideAnIsland) {
  const auto rate_after = [](double load) {
    Braked braked;
    braked.hinge.set(properties::joint_load, load);
    auto* response = braked.robot->find(collision::contact_interface)->values[0].response;
    EXPECT_TRUE(response->free_pass(h));
    const Vec3d now{0, 0, -2 * l};
    return -response->free_velocity(braked.robot->model().object_index("hinge"), {l, 0, 0}, now).z / l;
  };
  const double lost = h * 0.3 * 2 / of_axle;
  EXPECT_NEAR(rate_after(0) - rate_after(2), lost, 0.1 * lost);
}

}  // namespace
}  // namespace murosimf::dynamics
