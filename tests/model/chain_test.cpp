#include "murosimf/model/chain.h"

#include <limits>

#include <gtest/gtest.h>

#include "tests/fixtures.h"

namespace murosimf {
namespace {

using fixtures::difference;
using fixtures::error_of;
using fixtures::says;

// Rule: the seven objects, each with its data and its parent.
TEST(Chain, SevenObjects) {
  const Chain chain = Chain{}
                          .base("trunk")
                          .translation({1, 2, 3}, "up")
                          .rotation({0, 0, 2}, pi / 2, "left")
                          .revolute("hinge", {0, 3, 0})
                          .prismatic("slider", {0, 0, -5})
                          .fork(Chain{}.endpoint("a"), Chain{}.translation({0, 0, 1}, "b"));
  const auto& objects = chain.objects();
  ASSERT_EQ(objects.size(), 8u);
  const Kind kinds[] = {Kind::base,      Kind::translation, Kind::rotation, Kind::revolute,
                        Kind::prismatic, Kind::fork,        Kind::endpoint, Kind::translation};
  const int parents[] = {-1, 0, 1, 2, 3, 4, 5, 5};
  const char* names[] = {"trunk", "up", "left", "hinge", "slider", "", "a", "b"};
  for (std::size_t i = 0; i < objects.size(); ++i) {
    EXPECT_EQ(objects[i].kind, kinds[i]) << i;
    EXPECT_EQ(objects[i].parent, parents[i]) << i;
    EXPECT_EQ(objects[i].name, names[i]) << i;
    EXPECT_EQ(objects[i].is_joint(), i == 3 || i == 4) << i;
  }
  EXPECT_EQ(difference(objects[1].vector, {1, 2, 3}), 0);
  EXPECT_LT(difference(objects[2].turn, rotation_z(pi / 2)), 1e-16);  // the length of the axis does not count
  EXPECT_EQ(difference(objects[3].vector, {0, 1, 0}), 0);             // unit
  EXPECT_EQ(difference(objects[4].vector, {0, 0, -1}), 0);
}

// Rule: names of kinds are those of the paper's table 1.
TEST(Chain, KindNames) {
  EXPECT_STREQ(kind_name(Kind::base), "base");
  EXPECT_STREQ(kind_name(Kind::prismatic), "prismatic");
  EXPECT_STREQ(kind_name(Kind::endpoint), "endpoint");
}

// Rule: a fork has two branches, so three become two forks in a row; none ends the limb; one just goes on.
TEST(Chain, NumberOfBranches) {
  const auto tip = [](const char* name) { return Chain{}.translation({1, 0, 0}, name); };
  const Chain three = Chain{}.base().fork(tip("a"), tip("b"), tip("c"));
  ASSERT_EQ(three.objects().size(), 6u);  // base, fork, a, fork, b, c
  EXPECT_EQ(three.objects()[1].kind, Kind::fork);
  EXPECT_EQ(three.objects()[2].parent, 1);
  EXPECT_EQ(three.objects()[3].kind, Kind::fork);
  EXPECT_EQ(three.objects()[3].parent, 1);
  EXPECT_EQ(three.objects()[4].parent, 3);
  EXPECT_EQ(three.objects()[5].parent, 3);

  const Chain none = Chain{}.base().fork(std::vector<Chain>{});
  ASSERT_EQ(none.objects().size(), 2u);
  EXPECT_EQ(none.objects()[1].kind, Kind::endpoint);

  const Chain one = Chain{}.base().fork(std::vector<Chain>{tip("a")});
  ASSERT_EQ(one.objects().size(), 2u);
  EXPECT_EQ(one.objects()[1].parent, 0);
}

// Rule: parents come first, and every fork has two children, in forks of forks as well.
TEST(Chain, OrderOfRandomTrees) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Model model = fixtures::random_model(seed);
    std::vector<int> children(static_cast<std::size_t>(model.size()));
    for (int i = 1; i < model.size(); ++i) {
      ASSERT_GE(model.objects()[i].parent, 0);
      ASSERT_LT(model.objects()[i].parent, i);
      ++children[model.objects()[i].parent];
    }
    for (int i = 0; i < model.size(); ++i) {
      const Kind kind = model.objects()[i].kind;
      const int least = kind == Kind::fork ? 2 : 0;
      const int most = kind == Kind::fork ? 2 : kind == Kind::endpoint ? 0 : 1;
      EXPECT_GE(children[i], least) << seed << ' ' << i;
      EXPECT_LE(children[i], most) << seed << ' ' << i;
    }
  }
}

// Rule: with() and alias() belong to the object before them, and move along when the chain becomes a branch.
TEST(Chain, ConstantsAndAliasesBelongToTheirObject) {
  using namespace properties;
  const Chain leg = Chain{}.translation({0, 0, -1}, "shin").with(mass, 0.5).endpoint("foot").alias("toe");
  const Chain other = Chain{}.translation({0, 0, -1}, "other_shin").with(mass, 0.7).with(mass, 0.8);
  const Chain chain = Chain{}.base("trunk").with(mass, 2).alias("body").fork(leg, other);
  // trunk, fork, shin, foot, other_shin
  const double expected[] = {2, 0, 0.5, 0, 0.8};  // [kg], 0 for none; the last word counts
  for (int i = 0; i < 5; ++i) {
    const double* found = chain.constants().find(mass, i);
    EXPECT_EQ(found ? *found : 0, expected[i]) << i;
  }
  ASSERT_EQ(chain.aliases().size(), 2u);
  EXPECT_EQ(chain.aliases()[0], (std::pair<std::string, int>{"body", 0}));
  EXPECT_EQ(chain.aliases()[1], (std::pair<std::string, int>{"toe", 3}));
}

// Rule: a copy of a chain is independent of the original.
TEST(Chain, CopiesAreIndependent) {
  using namespace properties;
  const Chain original = Chain{}.base().with(mass, 1);
  Chain copy = original;
  copy.with(mass, 5).translation({1, 0, 0});
  EXPECT_EQ(*original.constants().find(mass, 0), 1);
  EXPECT_EQ(*copy.constants().find(mass, 0), 5);
  EXPECT_EQ(original.objects().size(), 1u);
}

// Rule: an axis needs a direction; the message names the object.
TEST(Chain, AxisWithoutDirection) {
  const double nan_value = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(says(error_of([] { Chain{}.base().revolute("knee", {0, 0, 0}); }), {"'knee'", "axis (0 0 0)"}));
  EXPECT_TRUE(says(error_of([] { Chain{}.base().prismatic("lift", {0, 0, 0}); }), {"'lift'", "axis"}));
  EXPECT_TRUE(says(error_of([] { Chain{}.base().rotation({0, 0, 0}, 1, "bend"); }), {"'bend'", "axis"}));
  EXPECT_TRUE(says(error_of([] { Chain{}.base().rotation({0, 0, 0}, 1); }), {"'rotation'", "axis"}));
  EXPECT_TRUE(says(error_of([&] { Chain{}.base().revolute("knee", {nan_value, 0, 1}); }), {"'knee'", "axis"}));
  EXPECT_TRUE(says(error_of([&] { Chain{}.base().revolute("knee", {infinity, 0, 1}); }), {"'knee'", "axis"}));
}

// Rule: nothing follows an endpoint or a fork; the message names what was to follow.
TEST(Chain, NothingFollowsTheEnd) {
  EXPECT_TRUE(says(error_of([] {
                     Chain{}.base().endpoint().translation({1, 0, 0}, "late");
                   }),
                   {"translation 'late'", "cannot follow"}));
  const Chain tip = Chain{}.endpoint();
  EXPECT_TRUE(says(error_of([&] {
                     Chain{}.base().fork(tip, tip).revolute("late", {1, 0, 0});
                   }),
                   {"revolute 'late'", "cannot follow"}));
  EXPECT_TRUE(says(error_of([&] { Chain{}.base().fork(tip, tip).fork(tip, tip); }), {"cannot follow"}));
  EXPECT_TRUE(says(error_of([&] { Chain{}.base().fork(tip, tip).endpoint("end"); }), {"endpoint 'end'"}));
}

// Rule: branches are not empty, and properties need an object to belong to.
TEST(Chain, EmptyPieces) {
  const Chain tip = Chain{}.endpoint();
  EXPECT_TRUE(says(error_of([&] { Chain{}.base().fork(tip, Chain{}); }), {"fork", "empty branch"}));
  EXPECT_TRUE(says(error_of([&] { Chain{}.base().fork(Chain{}, tip); }), {"fork", "empty branch"}));
  EXPECT_TRUE(says(error_of([] { Chain{}.with(properties::mass, 1); }), {"before the first object"}));
  EXPECT_TRUE(says(error_of([] { Chain{}.alias("nobody"); }), {"before the first object"}));
  EXPECT_TRUE(Chain{}.empty());
  EXPECT_FALSE(tip.empty());
}

// Rule: one name, one type.
TEST(Chain, ConstantOfTwoTypes) {
  constexpr Property<Vec3d> other_mass{{"mass", "kg", "-", "not a number"}};
  EXPECT_TRUE(says(error_of([&] {
                     Chain{}.base().with(properties::mass, 1).with(other_mass, {1, 2, 3});
                   }),
                   {"'mass'", "two types"}));
}

}  // namespace
}  // namespace murosimf
