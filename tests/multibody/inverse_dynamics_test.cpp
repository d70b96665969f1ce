// The arm of the textbooks: two links in a plane, whose torques and inertia matrix are known in closed form.
#include "murosimf/multibody/inverse_dynamics.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "murosimf/multibody/kinematics.h"
#include "tests/fixtures.h"

namespace murosimf::multibody {
namespace {

using fixtures::difference;

constexpr double m1 = 1.5, m2 = 0.8, l1 = 0.4, c1 = 0.15, c2 = 0.25, I1 = 0.02, I2 = 0.01, g = 9.81;

/// Hinged about z; the base is a flywheel of 3 kg on the axis of the first joint.
struct Arm {
  Arm(double q1, double q2, double qd1, double qd2) : model("arm", chain()), state(model.size()), links(3) {
    state.R[0] = Mat3d{};
    const auto& tree = model.tree();
    state.q[tree.links[1].object] = q1;
    state.q[tree.links[2].object] = q2;
    state.qd[tree.links[1].object] = qd1;
    state.qd[tree.links[2].object] = qd2;
    poses<double>(tree, state.q, state.r, state.R);
    link_motions<double>(tree, state.r, state.R, state.w[0], state.qd, links);
  }
  static Chain chain() {
    const auto slim = [](double I) { return SymMat3d{1e-3, I, I, 0, 0, 0}; };
    return Chain{}
        .base("base")
        .with(properties::mass, 3.0)
        .with(properties::inertia, diagonal(0.1))
        .revolute("upper", {0, 0, 1})
        .with(properties::mass, m1)
        .with(properties::center_of_mass, {c1, 0, 0})
        .with(properties::inertia, slim(I1))
        .translation({l1, 0, 0})
        .revolute("lower", {0, 0, 1})
        .with(properties::mass, m2)
        .with(properties::center_of_mass, {c2, 0, 0})
        .with(properties::inertia, slim(I2));
  }
  Model model;
  fixtures::State<double> state;
  std::vector<LinkMotion<double>> links;
};

struct Torques {
  double first, second;
};

/// Craig, Introduction to Robotics, ch. 6, with centers of mass inside the links; gravity g against y.
Torques textbook(double q1, double q2, double qd1, double qd2, double a1, double a2) {
  const double k = m2 * l1 * c2, h = k * std::sin(q2), M22 = I2 + m2 * c2 * c2, M12 = M22 + k * std::cos(q2);
  const double M11 = I1 + m1 * c1 * c1 + M22 + m2 * l1 * l1 + 2 * k * std::cos(q2);
  const double w2 = m2 * g * c2 * std::cos(q1 + q2), w1 = (m1 * c1 + m2 * l1) * g * std::cos(q1) + w2;
  return {M11 * a1 + M12 * a2 - h * (2 * qd1 * qd2 + qd2 * qd2) + w1, M12 * a1 + M22 * a2 + h * qd1 * qd1 + w2};
}

struct Found {
  std::vector<Wrenchd> force = std::vector<Wrenchd>(3);
  std::vector<double> torque = std::vector<double>(3, 7.0);
};

// Gravity is an acceleration of the base upwards.
TEST(InverseDynamics, PlanarArmInClosedForm) {
  for (const auto& [q1, q2, qd1, qd2, a1, a2] : {std::array{0.3, -0.8, 0.0, 0.0, 0.0, 0.0},
                                                 {0.3, -0.8, 1.5, -2.0, 0.0, 0.0},
                                                 {-2.0, 1.1, 0.4, 3.0, 5.0, -7.0}}) {
    const Arm arm(q1, q2, qd1, qd2);
    const std::vector<double> qdd{0, a1, a2};
    const std::vector<Wrenchd> external(3);
    Found found;
    inverse_dynamics<double>(arm.model.tree(), arm.links, {{}, {0, g, 0}}, qdd, external, found.force, found.torque);
    const Torques expected = textbook(q1, q2, qd1, qd2, a1, a2);
    EXPECT_NEAR(found.torque[1], expected.first, 1e-12);
    EXPECT_NEAR(found.torque[2], expected.second, 1e-12);
    EXPECT_EQ(found.torque[0], 0);
    EXPECT_NEAR(found.force[0].n.z, expected.first, 1e-12) << "the base bears what its joint takes";
  }
}

// What pushes at a link does not have to be made by its joints: at rest they hold against it, r x f.
TEST(InverseDynamics, JointsHoldAgainstPushes) {
  const Arm arm(0.3, -0.8, 0, 0);
  const Vec3d tip = arm.state.r[arm.model.object_index("lower")] + rotation_z(-0.5) * Vec3d{0.6, 0, 0}, push{3, -5, 2};
  std::vector<Wrenchd> external(3);
  external[2] = {cross(tip, push), push};
  Found found;
  inverse_dynamics<double>(arm.model.tree(), arm.links, {}, std::vector<double>(3), external, found.force,
                           found.torque);
  const Vec3d elbow{l1 * std::cos(0.3), l1 * std::sin(0.3), 0};
  EXPECT_NEAR(found.torque[1], -cross(tip, push).z, 1e-12);
  EXPECT_NEAR(found.torque[2], -cross(tip - elbow, push).z, 1e-12);
  EXPECT_LT(difference(found.force[0].f, -push), 1e-12);
}

// The corner of the two joints is the textbook's matrix; that of the base is all of it as one body.
TEST(InverseDynamics, MassMatrixInClosedForm) {
  const double q2 = -0.8, k = m2 * l1 * c2;
  const Arm arm(0.3, q2, 9, 9);
  std::vector<RigidInertia<double>> composite(3);
  std::vector<double> M(64, 5.0);
  mass_matrix(arm.model.tree(), arm.links, composite, M);
  const auto at = [&](std::size_t row, std::size_t column) { return M[8 * row + column]; };
  const double M22 = I2 + m2 * c2 * c2, M12 = M22 + k * std::cos(q2);
  EXPECT_NEAR(at(7, 7), M22, 1e-14);
  EXPECT_NEAR(at(6, 7), M12, 1e-14);
  EXPECT_NEAR(at(6, 6), I1 + m1 * c1 * c1 + M12 + m2 * l1 * l1 + k * std::cos(q2), 1e-14);
  EXPECT_NEAR(at(2, 6), at(6, 6), 1e-14) << "the base turns about the first joint's axis";
  EXPECT_NEAR(at(2, 2), 0.1 + at(6, 6), 1e-14);
  for (const std::size_t i : {3U, 4U, 5U}) {
    for (const std::size_t j : {3U, 4U, 5U}) EXPECT_NEAR(at(i, j), i == j ? 3 + m1 + m2 : 0, 1e-14);
  }
  const Vec3d first = (m1 * c1 + m2 * l1) * Vec3d{std::cos(0.3), std::sin(0.3), 0} +
                      m2 * c2 * Vec3d{std::cos(0.3 + q2), std::sin(0.3 + q2), 0};
  EXPECT_NEAR(at(6, 3), -first.y, 1e-14);
  EXPECT_NEAR(at(6, 4), first.x, 1e-14);
  for (std::size_t i = 0; i < 8; ++i) {
    for (std::size_t j = 0; j < 8; ++j) EXPECT_EQ(at(i, j), at(j, i));
  }
}

// Joints that speed up with the base held: its force is the rate of momentum, and with it held still that of the arm.
TEST(InverseDynamics, BaseFeelsWhatJointsTake) {
  const Arm arm(-2.0, 1.1, 0.4, 3.0);
  const std::vector<double> qdd{0, 5, -7};
  std::vector<Twistd> working(3, Twistd{{9, 9, 9}, {9, 9, 9}});
  const Wrenchd found = base_bias<double>(arm.model.tree(), arm.links, qdd, working);
  const auto rotating = [](double angle, double rate, double acceleration, double length) {
    const Vec3d along{std::cos(angle), std::sin(angle), 0}, across{-along.y, along.x, 0};
    return length * (acceleration * across - rate * rate * along);
  };
  const Vec3d force = rotating(-2.0, 0.4, 5, m1 * c1 + m2 * l1) + rotating(-0.9, 3.4, -2, m2 * c2);
  EXPECT_LT(difference(found.f, force), 1e-12);
  Torques without_weight = textbook(-2.0, 1.1, 0.4, 3.0, 5, -7);
  without_weight.first -= (m1 * c1 + m2 * l1) * g * std::cos(-2.0) + m2 * g * c2 * std::cos(-0.9);
  EXPECT_NEAR(found.n.z, without_weight.first, 1e-12);
}

}  // namespace
}  // namespace murosimf::multibody
