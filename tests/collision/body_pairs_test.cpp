// Hashes of contacts: every number that the next step goes on from, and the memory that goes on.
#include "murosimf/collision/body_pairs.h"

#include <gtest/gtest.h>

#include <functional>

namespace murosimf::collision {
namespace {

PairSet one_contact() {
  PairSet set;
  PairContact& c = set.points.emplace_back();
  c.shapes = 5;
  c.feature = 7;
  return set;
}

std::uint64_t hash(const PairSet& set) {
  Hasher hasher;
  append_hash(hasher, set);
  return hasher.value();
}

TEST(BodyPairs, HashIsOfAllThatGoesOn) {
  const std::vector<std::function<void(PairContact&)>> changes{[](PairContact& c) { c.shapes = 6; },
                                                               [](PairContact& c) { c.feature = 8; },
                                                               [](PairContact& c) { c.state = ContactState::slip; },
                                                               [](PairContact& c) { c.last_normal_force = 1; },
                                                               [](PairContact& c) { c.stretch.y = 1; },
                                                               [](PairContact& c) { c.slip_direction.z = 1; },
                                                               [](PairContact& c) { c.point.x = 1; },
                                                               [](PairContact& c) { c.normal.x = 1; },
                                                               [](PairContact& c) { c.force.x = 1; },
                                                               [](PairContact& c) { c.arm_a.x = 1; },
                                                               [](PairContact& c) { c.arm_b.x = 1; },
                                                               [](PairContact& c) { c.velocity_a.x = 1; },
                                                               [](PairContact& c) { c.velocity_b.x = 1; },
                                                               [](PairContact& c) { c.normal_damping = 1; },
                                                               [](PairContact& c) { c.tangent_damping = 1; }};
  const std::uint64_t before = hash(one_contact());
  EXPECT_EQ(hash(one_contact()), before);
  for (std::size_t i = 0; i < changes.size(); ++i) {
    PairSet set = one_contact();
    changes[i](set.points[0]);
    EXPECT_NE(hash(set), before) << i;
  }
  PairSet two = one_contact();
  two.points.push_back(two.points[0]);
  EXPECT_NE(hash(two), before);
  EXPECT_NE(hash({}), before);
}

TEST(ContactPoint, RecallsItsMemoryAndNothingElse) {
  ContactPoint old, now;
  old.feature = 7;
  old.stretch = {1, 2, 3};
  old.state = ContactState::slip;
  old.last_normal_force = 4;
  old.slip_direction = {0, 1, 0};
  old.depth = old.force.x = 5;
  recall(old, now);
  EXPECT_EQ(now.stretch.y, 2);
  EXPECT_EQ(now.state, ContactState::slip);
  EXPECT_EQ(now.last_normal_force, 4);
  EXPECT_EQ(now.slip_direction.y, 1);
  EXPECT_EQ(now.depth, 0);
  EXPECT_EQ(now.force.x, 0);
  EXPECT_EQ(now.feature, 0U);
}

}  // namespace
}  // namespace murosimf::collision
