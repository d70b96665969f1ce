#include "murosimf/collision/body_carry_law.h"

#include <gtest/gtest.h>

#include "tests/collision/movers.h"

namespace murosimf::collision {
namespace {

using fixtures::difference;

// Rule: friction that is just as large as the cone allows sticks; numbers are powers of two, so that nothing is rounded.
TEST(BodyCarryLaw, SticksOnTheEdgeOfItsCone) {
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
    BodyCarryLaw().push(movers.all, movers.set, 1e-3);
    const PairContact& after = movers.set.points[0];
    EXPECT_LT(difference(after.force, {0, -4, 8}), 1e-12) << beyond;
    EXPECT_EQ(after.state, beyond > 0 ? ContactState::slip : ContactState::stick);
    EXPECT_EQ(after.tangent_damping, beyond > 0 ? 0 : 3 + 1e-3 * 4096);
  }
}

}  // namespace
}  // namespace murosimf::collision
