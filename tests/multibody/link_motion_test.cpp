// Axes, velocities and inertial forces of single links in closed form; sums over many stand in forward_dynamics_test.
#include "murosimf/multibody/link_motion.h"

#include <gtest/gtest.h>

#include "murosimf/multibody/kinematics.h"
#include "tests/fixtures.h"

namespace murosimf::multibody {
namespace {

using fixtures::difference;

constexpr double m = 2, Ixx = 0.03, Iyy = 0.05, Izz = 0.07;

/// A base without mass at (5, 6, 7) that turns with `w`, and one joint that carries the mass.
struct OneJoint {
  OneJoint(Chain chain, double q, double qd, const Vec3d& w)
      : model("one", std::move(chain)), state(model.size()), links(2) {
    state.r[0] = {5, 6, 7};
    state.R[0] = Mat3d{};
    const int joint = model.tree().links[1].object;
    state.q[joint] = q;
    state.qd[joint] = qd;
    poses<double>(model.tree(), state.q, state.r, state.R);
    link_motions<double>(model.tree(), state.r, state.R, w, state.qd, links);
  }
  Model model;
  fixtures::State<double> state;
  std::vector<LinkMotion<double>> links;
};

Chain with_mass(Chain chain) {
  return chain.with(properties::mass, m).with(properties::inertia, SymMat3d{Ixx, Iyy, Izz, 0, 0, 0});
}

// A slider on a turntable: centripetal and Coriolis acceleration of its mass, w = 3 rad/s about z, 0.4 m out, 0.9 m/s.
TEST(LinkMotionOfOne, SliderOnATurntable) {
  const OneJoint slider(with_mass(Chain{}.base("table").prismatic("slider", {1, 0, 0})), 0.4, 0.9, {0, 0, 3});
  const LinkMotion<double>& link = slider.links[1];
  EXPECT_LT(difference(link.axis.w, {}), 1e-15);
  EXPECT_LT(difference(link.axis.v, {1, 0, 0}), 1e-15);
  EXPECT_LT(difference(link.velocity.w, {0, 0, 3}), 1e-15);
  EXPECT_LT(difference(link.velocity.v, {0.9, 0, 0}), 1e-15) << "at the base's origin";
  const Vec3d force = m * Vec3d{-9 * 0.4, 2 * 3 * 0.9, 0};
  EXPECT_LT(difference(link.bias_force.f, force), 1e-12);
  EXPECT_LT(difference(link.bias_force.n, cross(Vec3d{0.4, 0, 0}, force)), 1e-12);
}

// A wheel whose axle is 0.5 m beside the base's origin and turns about z itself: as a top it takes the moment w x L.
TEST(LinkMotionOfOne, WheelOnATurntable) {
  const OneJoint wheel(with_mass(Chain{}.base("table").translation({0, 0.5, 0}).revolute("wheel", {0, 1, 0})), 0, 4,
                       {0, 0, 3});
  const LinkMotion<double>& link = wheel.links[1];
  EXPECT_LT(difference(link.axis.w, {0, 1, 0}), 1e-15);
  EXPECT_LT(difference(link.axis.v, {}), 1e-15) << "the axle goes through the base's origin";
  EXPECT_LT(difference(link.velocity.w, {0, 4, 3}), 1e-15);
  const Vec3d force = m * Vec3d{0, -9 * 0.5, 0};  // keeps the center on its circle
  EXPECT_LT(difference(link.bias_force.f, force), 1e-12);
  // Euler: I dw/dt + w x I w in the body's axes, with dw/dt = (0, 0, 3) x (0, 4, 0) = (-12, 0, 0)
  EXPECT_LT(difference(link.bias_force.n, {Ixx * -12 + 4 * Izz * 3 - 3 * Iyy * 4, 0, 0}), 1e-12);
}

// A rod that swings about an axis beside the origin: velocity of the body's point that is at the origin, and momentum.
TEST(LinkMotionOfOne, SwingBesideTheOrigin) {
  Chain chain = Chain{}.base("wall").translation({0.3, -0.2, 0.1}).revolute("swing", {1, 0, 0});
  chain.with(properties::center_of_mass, {0, 0, -0.5});
  const OneJoint swing(with_mass(chain), 0, 2, {});
  const LinkMotion<double>& link = swing.links[1];
  EXPECT_LT(difference(link.axis.v, {0, 0.1, 0.2}), 1e-15);
  EXPECT_LT(difference(link.velocity.v, {0, 0.2, 0.4}), 1e-15);
  EXPECT_LT(difference(link.bias_force.f, {0, 0, m * 4 * 0.5}), 1e-12) << "towards the axis";
  const std::span<const LinkMotion<double>> all = swing.links;
  const Vec3d velocity{0, 2 * 0.5, 0}, center{0.3, -0.2, -0.4};
  EXPECT_LT(difference(linear_momentum(all), m * velocity), 1e-12);
  EXPECT_LT(difference(momentum(all).f, m * velocity), 1e-12);
  EXPECT_LT(difference(momentum(all).n, cross(center, m * velocity) + Vec3d{Ixx * 2, 0, 0}), 1e-12);
  EXPECT_NEAR(kinetic_energy(all, Vec3d{0, 3, 0}), 0.5 * m * 16 + 0.5 * Ixx * 4, 1e-12);
  EXPECT_NEAR(potential_energy(all, swing.state.r[0], Vec3d{0, 0, -10}), m * 10 * (7 - 0.4), 1e-12);
  EXPECT_EQ(composite_inertia(all).mass, m);
  EXPECT_LT(difference(composite_inertia(all).first, m * center), 1e-12);
}

// Rule: rows are filled, whatever stood there; the base has no axis, and no acceleration by itself.
TEST(LinkMotionOfOne, RowsForgetWhatTheyHeld) {
  OneJoint slider(with_mass(Chain{}.base("table").prismatic("slider", {1, 0, 0})), 0.4, 0.9, {0, 0, 3});
  const std::vector<LinkMotion<double>> fresh = slider.links;
  for (auto& link : slider.links) {
    link.axis = link.velocity = link.bias = {{9, 9, 9}, {9, 9, 9}};
    link.inertia.mass = 9;
    link.bias_force = {{9, 9, 9}, {9, 9, 9}};
  }
  const fixtures::State<double>& state = slider.state;
  link_motions<double>(slider.model.tree(), state.r, state.R, Vec3d{0, 0, 3}, state.qd, slider.links);
  EXPECT_EQ(norm(slider.links[0].axis.w) + norm(slider.links[0].axis.v), 0);
  EXPECT_EQ(norm(slider.links[0].bias.w) + norm(slider.links[0].bias.v), 0);
  for (const std::size_t l : {0U, 1U}) {
    const LinkMotion<double>&again = slider.links[l], &first = fresh[l];
    EXPECT_EQ(difference(again.axis.w, first.axis.w) + difference(again.axis.v, first.axis.v), 0) << l;
    EXPECT_EQ(difference(again.velocity.w, first.velocity.w) + difference(again.velocity.v, first.velocity.v), 0) << l;
    EXPECT_EQ(difference(again.bias.w, first.bias.w) + difference(again.bias.v, first.bias.v), 0) << l;
    EXPECT_EQ(difference(again.bias_force.f, first.bias_force.f) + difference(again.bias_force.n, first.bias_force.n),
              0)
        << l;
    EXPECT_EQ(again.inertia.mass, first.inertia.mass) << l;
  }
}

// By the parallel axis theorem, turned by a right angle about z: x and y of the body's own inertia change places.
TEST(LinkMotionOfOne, InertiaIsAboutTheBasesOrigin) {
  const Vec3d c{0.3, -0.2, 0.1};
  const OneJoint turned(with_mass(Chain{}.base("wall").translation(c).revolute("joint", {0, 0, 1})), pi / 2, 0, {});
  const RigidInertia<double>& found = turned.links[1].inertia;
  EXPECT_NEAR(found.second.xx, Iyy + m * (c.y * c.y + c.z * c.z), 1e-15);
  EXPECT_NEAR(found.second.yy, Ixx + m * (c.x * c.x + c.z * c.z), 1e-15);
  EXPECT_NEAR(found.second.zz, Izz + m * (c.x * c.x + c.y * c.y), 1e-15);
  EXPECT_NEAR(found.second.xy, -m * c.x * c.y, 1e-15);
  EXPECT_NEAR(found.second.xz, -m * c.x * c.z, 1e-15);
  EXPECT_NEAR(found.second.yz, -m * c.y * c.z, 1e-15);
}

// The moment of momentum of a body that turns about each axis of the world, from its own axes and back.
TEST(LinkMotionOfOne, InertiaTurnsWithTheBody) {
  const Mat3d R = rotation_z(0.7) * rotation_x(-0.4) * rotation_y(1.1);
  const OneJoint turned(with_mass(Chain{}.base("wall").rotation(R).revolute("joint", {0, 0, 1})), 0, 0, {});
  for (const Vec3d& w : {Vec3d{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) {
    const Vec3d own = transpose(R) * w;
    EXPECT_LT(difference(turned.links[1].inertia.second * w, R * Vec3d{Ixx * own.x, Iyy * own.y, Izz * own.z}), 1e-15);
  }
}

// Links without mass have none, whatever stood there before.
TEST(LinkMotionOfOne, WithoutMassThereIsNoForce) {
  OneJoint joint(Chain{}.base("wall").revolute("joint", {0, 0, 1}), 0.3, 2, {1, 2, 3});
  joint.links[1].inertia.mass = 5;
  joint.links[1].bias_force = {{1, 2, 3}, {4, 5, 6}};
  link_motions<double>(joint.model.tree(), joint.state.r, joint.state.R, {1, 2, 3}, joint.state.qd, joint.links);
  for (const LinkMotion<double>& link : joint.links) {
    EXPECT_EQ(link.inertia.mass, 0);
    EXPECT_EQ(link.inertia.second.xx, 0);
    EXPECT_EQ(norm(link.bias_force.f) + norm(link.bias_force.n), 0);
  }
}

}  // namespace
}  // namespace murosimf::multibody
