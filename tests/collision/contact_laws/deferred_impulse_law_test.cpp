#include "murosimf/collision/contact_laws/deferred_impulse_law.h"

#include <gtest/gtest.h>

#include "tests/collision/movers.h"

namespace murosimf::collision {
namespace {

using fixtures::difference;

// Rule: friction that is just as large as the cone allows sticks; numbers are powers of two, so that nothing is rounded.
TEST(DeferredImpulseLaw, SticksOnTheEdgeOfItsCone) {
  ContactParameters p;
  p.stiffness = 8192;
  p.tangent_stiffness = 4096;
  p.tangent_damping = 3;
  p.friction = 0.5;
  for (const double beyond : {0.0, 1e-6}) {
    Movers movers;
    movers.add("light", ball(0.1, 1));
    movers.add("heavy", ball(0.1, 2), {0, 0, -0.199});
    PairContact c = joint_of(0, 1);
    c.normal = {0, 0, 1};
    c.depth = 0x1p-10;                     // 8 N
    c.stretch = {0, 0x1p-10 + beyond, 0};  // 4 N
    movers.set.points = {c};
    movers.set.parameters = {p};
    DeferredImpulseLaw().push(movers.all, movers.set, 1e-3, movers.serial);
    const PairContact& after = movers.set.points[0];
    EXPECT_LT(difference(after.force, {0, -4, 8}), 1e-12) << beyond;
    EXPECT_EQ(after.state, beyond > 0 ? ContactState::slip : ContactState::stick);
    EXPECT_EQ(after.tangent_damping, beyond > 0 ? 0 : 3 + 1e-3 * 4096);
  }
}

/// One contact between two bodies that DeferredImpulseLaw pushes for a step of 2 ms, with a slanted normal.
struct Slanted {
  explicit Slanted(const Vec3d& velocity, double friction) {
    p.stiffness = 8000;
    p.damping = 30;
    p.tangent_stiffness = 5000;
    p.tangent_damping = 20;
    p.friction = friction;
    p.theta = 0.5;
    movers.add("light", ball(0.1, 1));
    movers.add("heavy", ball(0.1, 2));
    PairContact c = joint_of(0, 1);
    c.normal = n;
    c.depth = 2e-3;
    c.stretch = s;
    c.velocity = velocity;
    movers.set.points = {c};
    movers.set.parameters = {p};
    DeferredImpulseLaw().push(movers.all, movers.set, h, movers.serial);
  }
  [[nodiscard]] const PairContact& after() const { return movers.set.points[0]; }

  static constexpr double h = 2e-3;  // [s]
  const Vec3d n{0.48, 0.6, 0.64};    // [1]
  const Vec3d s{4e-5, -3.2e-5, 0};   // [m] across n
  ContactParameters p;
  Movers movers;
};

// Law: f = (k depth - (d + theta h k) v_n) n - kt (s + h v_t) - (ct + h kt) v_t; v_t is what is left of v without v_n n.
TEST(DeferredImpulseLaw, SticksWithNormalAndTangentialMotionApart) {
  const Vec3d v_t{0.05, -0.04, 0};  // [m/s] across n
  const Slanted contact(v_t + 0.1 * Vec3d{0.48, 0.6, 0.64}, 5);
  ASSERT_EQ(contact.after().state, ContactState::stick);
  const double f_n = 8000 * 2e-3 - (30 + 0.5 * 2e-3 * 8000) * 0.1;  // 12.2 N
  const Vec3d f_t = -5000 * (contact.s + 2e-3 * v_t) - (20 + 2e-3 * 5000) * v_t;
  EXPECT_LT(difference(contact.after().force, f_n * contact.n + f_t), 1e-12);
  EXPECT_LT(difference(contact.after().stretch, contact.s + 2e-3 * v_t), 1e-17);
  EXPECT_EQ(contact.after().normal_damping, 38);
}

// Law: friction of mu f_n straight against the motion; the spring returns to where it holds just that: f_t = -kt s - ct v_t.
TEST(DeferredImpulseLaw, SlidesOnItsCone) {
  const Vec3d v_t{0.5, -0.4, 0};  // [m/s] across n, as the stretch is
  const Slanted contact(v_t + 0.1 * Vec3d{0.48, 0.6, 0.64}, 0.25);
  ASSERT_EQ(contact.after().state, ContactState::slip);
  const Vec3d f_t = (-0.25 * 12.2 / norm(v_t)) * v_t;
  EXPECT_LT(difference(contact.after().force, 12.2 * contact.n + f_t), 1e-12);
  EXPECT_LT(difference(-5000 * contact.after().stretch - 20 * v_t, f_t), 1e-12);
}

// Rule: bodies do not stick together; what would pull is open and begins anew.
TEST(DeferredImpulseLaw, OpensWhereItWouldPull) {
  const Slanted contact(0.5 * Vec3d{0.48, 0.6, 0.64} + Vec3d{0.05, -0.04, 0}, 0.25);  // 16 N - 38 N s/m * 0.5 m/s
  EXPECT_EQ(contact.after().state, ContactState::open);
  EXPECT_EQ(norm(contact.after().force), 0);
  EXPECT_EQ(norm(contact.after().stretch), 0);
}

}  // namespace
}  // namespace murosimf::collision
