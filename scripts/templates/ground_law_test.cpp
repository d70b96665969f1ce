// The contact law new_name: its force, and a block that comes to rest on it.
#include "murosimf/collision/contact_laws/new_name.h"

#include <gtest/gtest.h>

#include "tests/collision/law_fixtures.h"
#include "tests/physics/rig.h"

namespace murosimf::collision {
namespace {

const NewName law;

// k depth - d v_n = 1e4 N/m * 1 mm + 50 N s/m * 0.1 m/s. Tolerance: rounding.
TEST(NewName, PushesAlongTheNormal) {
  LawCase set = one_point(1e-3, {0.02, 0, -0.1});
  set.prepare(law);
  EXPECT_LT(difference(set.points[0].force, {0, 0, 15}), 1e-12);
  EXPECT_TRUE(set.accepted_by(law));
}

TEST(NewName, NeverPulls) {
  LawCase set = one_point(1e-3, {0, 0, 0.3});
  set.prepare(law);
  EXPECT_EQ(norm(set.points[0].force), 0);
  EXPECT_EQ(set.points[0].state, ContactState::open);
}

// 10 N on 1e4 N/m. Tolerance: what is left of the fall after 4 s.
TEST(NewName, CarriesAWeight) {
  Block block = resting_block({});
  block.position.z = 0.002;
  for (int i = 0; i < 4000; ++i) block.step(law);
  EXPECT_NEAR(block.position.z, -1e-3, 1e-9);
}

TEST(NewName, HasItsName) {
  const auto named = test::law_named("new_name");
  EXPECT_NE(dynamic_cast<const NewName*>(named.get()), nullptr);
}

}  // namespace
}  // namespace murosimf::collision
