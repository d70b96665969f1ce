#include "murosimf/collision/inner_pairs.h"

#include <gtest/gtest.h>
#include <set>

#include "murosimf/collision/compound.h"
#include "tests/fixtures.h"

namespace murosimf::collision {
namespace {

using fixtures::placed;

/// Five links in a row, 0.3 m apart, with balls; the third link also carries a ball that reaches back into the base's,
/// on an object of its own, and the fifth one without a name.
Model arm() {
  using namespace properties;
  Chain chain;
  chain.base("trunk").with(shapes, {placed(Sphere{0.1}), placed(Sphere{0.1}, {0, 0.5, 0})});
  for (const std::string name : {"one", "two", "three", "four"}) {
    chain.translation({0.3, 0, 0}).revolute(name, {0, 1, 0}).with(shapes, {placed(Sphere{0.1})});
    if (name == "two") chain.translation({-0.5, 0, 0}, "spur").with(shapes, {placed(Sphere{0.1})});
    if (name == "two") chain.translation({0.5, 0, 0}, "mark");
  }
  return Model("arm", chain);
}

using Names = std::pair<std::string, std::string>;

/// Names of the objects whose shapes may touch.
std::set<Names> allowed(const Model& model, const std::vector<ExcludedPair>& excluded) {
  const auto shapes = colliding_shapes(model);
  const InnerPairs inner(model, shapes, excluded);
  std::set<Names> result;
  for (int a = 0; a < static_cast<int>(shapes.size()); ++a) {
    EXPECT_FALSE(inner.may_touch(a, a));
    for (int b = a + 1; b < static_cast<int>(shapes.size()); ++b) {
      EXPECT_EQ(inner.may_touch(a, b), inner.may_touch(b, a));
      if (!inner.may_touch(a, b)) continue;
      result.emplace(model.objects()[shapes[a].object].name, model.objects()[shapes[b].object].name);
    }
  }
  return result;
}

// Rule: not within a link, not with the link before, not what overlaps at rest.
TEST(InnerPairs, NeighborsAndOverlapsAtRestNeverTouch) {
  // the spur overlaps the nearer ball of the trunk at rest, but not the one at its side
  const std::set<Names> expected{{"trunk", "two"}, {"trunk", "three"}, {"trunk", "four"}, {"one", "three"},
                                 {"one", "four"},  {"two", "four"},    {"trunk", "spur"}, {"spur", "four"}};
  EXPECT_EQ(allowed(arm(), {}), expected);
  const Model model = arm();
  const auto shapes = colliding_shapes(model);
  const InnerPairs inner(model, shapes, {});
  const int spur = 4;
  ASSERT_EQ(model.objects()[shapes[spur].object].name, "spur");
  EXPECT_FALSE(inner.may_touch(0, spur));
  EXPECT_TRUE(inner.may_touch(1, spur));
}

// Rule: names exclude the shapes of an object, or of its whole link if it has none.
TEST(InnerPairs, PairsAreExcludedByName) {
  auto expected = allowed(arm(), {});
  expected.erase({"trunk", "three"});
  EXPECT_EQ(allowed(arm(), {{"three", "trunk"}}), expected);
  expected.erase({"spur", "four"});
  EXPECT_EQ(allowed(arm(), {{"three", "trunk"}, {"spur", "four"}}), expected);
  expected.erase({"two", "four"});
  EXPECT_EQ(allowed(arm(), {{"three", "trunk"}, {"mark", "four"}}), expected);
}

TEST(InnerPairs, UnknownObjectNamesTheNearest) {
  EXPECT_TRUE(fixtures::says(fixtures::error_of([] {
                               allowed(arm(), {{"trunk", "thre"}});
                             }),
                             {"excluded pair", "'thre'", "'three'"}));
}

/// Pairs of shapes that the compound finds when the arm is rolled up in one place.
std::set<std::pair<int, int>> pairs_when_rolled_up(const CompoundOptions& options) {
  const Model model = arm();
  Compound compound(model, options);
  compound.refit(std::vector<Vec3d>(static_cast<std::size_t>(model.size())),
                 std::vector<Mat3d>(static_cast<std::size_t>(model.size())));
  std::set<std::pair<int, int>> found;
  for_inner_pairs(compound, [&](int a, int b) { return found.emplace(a, b).second; });
  return found;
}

// Rule: off by default; on, it finds the allowed pairs, each once.
TEST(InnerPairs, AreOffByDefault) {
  EXPECT_TRUE(pairs_when_rolled_up({}).empty());
  // trunk's ball 0 with two, three, four; its ball 1 is too far; one with three, four; two with four; spur with four
  const std::set<std::pair<int, int>> expected{{0, 3}, {0, 5}, {0, 6}, {2, 5}, {2, 6}, {3, 6}, {4, 6}};
  for (const std::string volume : {"sphere", "aabb", "obb", "capsule"}) {
    EXPECT_EQ(pairs_when_rolled_up({.volume = volume, .inner = true}), expected) << volume;
  }
}

}  // namespace
}  // namespace murosimf::collision
