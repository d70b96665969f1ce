// Which entities are solved together: chains of contacts, those that cannot be pushed or cannot answer, laws that want it.
#include "murosimf/collision/contact_laws/islands.h"

#include <gtest/gtest.h>

#include "tests/collision/movers.h"

namespace murosimf::collision {
namespace {

/// Seven balls far from each other.
struct Seven : Movers {
  Seven() {
    for (int i = 0; i < 7; ++i) add("ball_" + std::to_string(i), ball(0.1, 1 + i), {2.0 * i, 0, 0});
  }
  std::vector<int> find(const std::vector<std::pair<int, int>>& contacts) {
    set.points.clear();
    for (const auto& [a, b] : contacts) set.points.push_back(joint_of(a, b));
    islands.find(all, set);
    std::vector<int> numbers;
    for (int i = 0; i < 7; ++i) numbers.push_back(islands.of(i));
    return numbers;
  }
  Islands islands;
};

using Numbers = std::vector<int>;

TEST(IslandNumbers, WhoTouchesNobodyHasNone) {
  Seven balls;
  EXPECT_EQ(balls.find({}), (Numbers{-1, -1, -1, -1, -1, -1, -1}));
  EXPECT_EQ(balls.islands.count(), 0);
}

// Rule: contacts join, directly and through others, in whatever order they come; numbers go by the first member.
TEST(IslandNumbers, ChainsAreOneIsland) {
  Seven balls;
  const Numbers expected{-1, 0, 1, 0, 1, 0, 1};
  EXPECT_EQ(balls.find({{1, 3}, {2, 4}, {3, 5}, {4, 6}}), expected);
  EXPECT_EQ(balls.islands.count(), 2);
  EXPECT_EQ(balls.find({{4, 6}, {3, 5}, {2, 4}, {1, 3}}), expected);
  EXPECT_EQ(balls.find({{3, 5}, {2, 6}, {1, 5}, {4, 6}}), expected);
  EXPECT_EQ(balls.find({{5, 6}, {3, 4}, {1, 2}, {2, 6}, {4, 5}}), (Numbers{-1, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(balls.islands.count(), 1);
  EXPECT_EQ(balls.find({{0, 6}, {5, 6}, {4, 5}, {3, 4}, {2, 3}, {1, 2}}), (Numbers{0, 0, 0, 0, 0, 0, 0}));
}

// Rule: members and contacts of an island, in their order; a contact belongs to the island of its side that can be pushed.
TEST(IslandNumbers, MembersAndContactsAreListed) {
  Seven balls;
  Movers::stand_fast(balls.all[3]);
  EXPECT_EQ(balls.find({{4, 6}, {3, 5}, {2, 4}, {1, 5}, {3, 4}}), (Numbers{-1, 0, 1, -1, 1, 0, 1}));
  const auto list = [](std::span<const int> row) { return Numbers(row.begin(), row.end()); };
  EXPECT_EQ(list(balls.islands.members(0)), (Numbers{1, 5}));
  EXPECT_EQ(list(balls.islands.members(1)), (Numbers{2, 4, 6}));
  EXPECT_EQ(list(balls.islands.contacts(0)), (Numbers{1, 3}));
  EXPECT_EQ(list(balls.islands.contacts(1)), (Numbers{0, 2, 4}));
  EXPECT_EQ(balls.find({{0, 3}}), (Numbers{0, -1, -1, -1, -1, -1, -1}));
  EXPECT_EQ(list(balls.islands.members(0)), (Numbers{0}));
  EXPECT_EQ(list(balls.islands.contacts(0)), (Numbers{0}));
}

// Nothing of the step before stays.
TEST(IslandNumbers, BeginAnewInEveryStep) {
  Seven balls;
  (void)balls.find({{0, 1}, {1, 2}, {5, 6}});
  EXPECT_EQ(balls.find({{1, 6}}), (Numbers{-1, 0, -1, -1, -1, -1, 0}));
  EXPECT_EQ(balls.islands.count(), 1);
}

// Rule: an entity that cannot be pushed joins no others: it stands between two islands.
TEST(IslandNumbers, WhoCannotBePushedJoinsNobody) {
  Seven balls;
  Movers::stand_fast(balls.all[2]);
  EXPECT_EQ(balls.find({{0, 2}, {2, 4}}), (Numbers{0, -1, -1, -1, 1, -1, -1}));
  EXPECT_EQ(balls.islands.of(joint_of(0, 2)), 0);
  EXPECT_EQ(balls.islands.of(joint_of(2, 4)), 1);
}

TEST(IslandNumbers, SoDoesALevelThatCannotAnswer) {
  Seven balls;
  balls.all[1].interface.response = nullptr;
  EXPECT_EQ(balls.find({{0, 1}, {1, 2}}), (Numbers{0, -1, 1, -1, -1, -1, -1}));
  balls.all[0].interface.response = nullptr;
  EXPECT_EQ(balls.find({{0, 1}}), (Numbers{-1, -1, -1, -1, -1, -1, -1}));
  EXPECT_EQ(balls.islands.of(joint_of(0, 1)), -1);
}

// Limbs of one robot that touch each other want an island, too.
TEST(IslandNumbers, ContactWithItselfIsAnIsland) {
  Seven balls;
  EXPECT_EQ(balls.find({{3, 3}}), (Numbers{-1, -1, -1, 0, -1, -1, -1}));
}

// Rule: a law may want an island for an entity that touches none; not for one that is frozen or stands.
TEST(IslandNumbers, OfLawsThatWantThem) {
  Seven balls;
  const Request always(IslandUse::always), when_touching(IslandUse::when_touching), never(IslandUse::never);
  balls.all[0].interface.law = &never;
  balls.all[1].interface.law = &when_touching;
  for (const int i : {2, 3, 4, 5}) balls.all[static_cast<std::size_t>(i)].interface.law = &always;
  Movers::stand_fast(balls.all[3]);
  balls.all[4].entity->freeze("test");
  EXPECT_EQ(balls.find({}), (Numbers{-1, -1, 0, -1, -1, 1, -1}));
  EXPECT_EQ(balls.islands.count(), 2);
  EXPECT_EQ(balls.find({{1, 5}, {0, 6}}), (Numbers{0, 1, 2, -1, -1, 1, 0}));
}

}  // namespace
}  // namespace murosimf::collision
