// The law new_name between moving bodies: its force, and that nothing is lost.
#include "murosimf/collision/contact_laws/new_name.h"

#include <gtest/gtest.h>

#include "tests/collision/meeting.h"

namespace murosimf::collision {
namespace {

using fixtures::difference;

// f = max(0, k depth - d v_n) along the normal, at the velocities of the material points.
TEST(NewName, ForceIsThatOfItsFormula) {
  Meeting meeting("new_name");
  meeting.rig.simulation.step();
  ASSERT_EQ(meeting.set().points.size(), 1U);
  const PairContact& c = meeting.set().points[0];
  const ContactParameters& p = meeting.set().parameters[c.surface];
  const double f_n = p.stiffness * c.depth - p.damping * dot(c.velocity, c.normal);
  ASSERT_GT(f_n, 0);
  EXPECT_LT(difference(c.force, f_n * c.normal), 1e-9);
}

// Law of action and reaction. Tolerance: rounding of 1 N s.
TEST(NewName, KeepsMomentum) {
  Meeting meeting("new_name");
  const Vec3d before = meeting.total().f;
  for (int i = 0; i < 50; ++i) meeting.rig.simulation.step();
  EXPECT_LT(difference(meeting.total().f, before), 1e-12);
}

}  // namespace
}  // namespace murosimf::collision
