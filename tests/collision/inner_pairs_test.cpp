#include "murosimf/collision/inner_pairs.h"

#include <gtest/gtest.h>
#include <set>

#include "murosimf/collision/compound.h"
#include "murosimf/collision/contact_properties.h"
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
std::set<Names> allowed(const Model& model, const ExcludedPairs& excluded) {
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

// Rule: a joint that cannot stand at zero rests at the end next to it; what overlaps there never touches.
TEST(InnerPairs, RestIsWhereTheRangeLetsJointsBe) {
  const auto forearm = [](const Vec3d& range) {
    using namespace properties;
    Chain chain = Chain{}.base("trunk").with(shapes, {placed(Sphere{0.1})});
    chain.translation({0, 0, 0.3}).revolute("shoulder", {0, 1, 0}).with(shapes, {placed(Sphere{0.05})});
    chain.revolute("elbow", {0, 1, 0}).with(joint_range, range).with(shapes, {placed(Sphere{0.1}, {0, 0, -0.25})});
    return Model("forearm", chain);
  };
  const std::set<Names> nothing, apart{{"trunk", "elbow"}};
  EXPECT_EQ(allowed(forearm({-1, 1, 0}), {}), nothing);
  EXPECT_EQ(allowed(forearm({0.2, 1, 0}), {}), nothing);
  EXPECT_EQ(allowed(forearm({1, 2, 0}), {}), apart);
  EXPECT_EQ(allowed(forearm({-2, -1, 0}), {}), apart);
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

/// The arm with other kinds of shapes, in order, and more about its base.
Model arm_with(const std::vector<std::uint32_t>& kinds, const ExcludedPairs& excluded, const AllowedPairs& allowed) {
  using namespace properties;
  std::size_t next = 0;
  const auto ball = [&](const Vec3d& place = {}) {
    PlacedShape shape = placed(Sphere{0.1}, place);
    const std::uint32_t bits = kinds.empty() ? 5 : kinds[next++];
    shape.contact_type = bits % 4;
    shape.contact_affinity = bits / 4;
    return shape;
  };
  Chain chain;
  chain.base("trunk").with(shapes, {ball(), ball({0, 0.5, 0})});
  chain.with(excluded_pairs, excluded).with(allowed_pairs, allowed);
  for (const std::string name : {"one", "two", "three", "four"}) {
    chain.translation({0.3, 0, 0}).revolute(name, {0, 1, 0}).with(shapes, {ball()});
    if (name == "two") chain.translation({-0.5, 0, 0}, "spur").with(shapes, {ball()});
    if (name == "two") chain.translation({0.5, 0, 0}, "mark");
  }
  return Model("arm", chain);
}

// Rule: kinds only take pairs away from those of the other rules.
TEST(InnerPairs, KindsOfShapesAreCompared) {
  const Model usual = arm();
  const InnerPairs all(usual, colliding_shapes(usual), {});
  fixtures::Dice dice("kinds");
  int touching = 0, parted = 0;
  for (int round = 0; round < 100; ++round) {
    std::vector<std::uint32_t> kinds;
    for (int i = 0; i < 7; ++i) kinds.push_back(static_cast<std::uint32_t>(dice.uniform(0, 15.999)));
    const Model model = arm_with(kinds, {}, {});
    const InnerPairs inner(model, colliding_shapes(model), {});
    for (int a = 0; a < 7; ++a) {
      for (int b = 0; b < 7; ++b) {
        const bool share = ((kinds[a] % 4) & (kinds[b] / 4)) != 0 || ((kinds[b] % 4) & (kinds[a] / 4)) != 0;
        EXPECT_EQ(inner.may_touch(a, b), all.may_touch(a, b) && share);
        touching += inner.may_touch(a, b);
        parted += all.may_touch(a, b) && !share;
      }
    }
  }
  EXPECT_GT(touching, 100);
  EXPECT_GT(parted, 100);
}

// Rule: the model's own pairs count like those of the entity's options.
TEST(InnerPairs, ModelExcludesPairsToo) {
  auto expected = allowed(arm(), {});
  expected.erase({"trunk", "three"});
  EXPECT_EQ(allowed(arm_with({}, {{"three", "trunk"}}, {}), {}), expected);
  for (const char* part : {"two", "spur"}) expected.erase({part, "four"});  // both of the link that has the mark
  EXPECT_EQ(allowed(arm_with({}, {{"three", "trunk"}}, {}), {{"mark", "four"}}), expected);
}

// Rule: an allowed pair touches whatever forbids it: kinds, exclusion, neighborhood, overlap at rest.
TEST(InnerPairs, AllowedPairsTouchWhateverForbidsThem) {
  auto expected = allowed(arm(), {});
  const AllowedPairs neighbors{{{"one"}, {"two"}}, {{"trunk", 0}, {"spur"}}};
  expected.insert({{"one", "two"}, {"trunk", "spur"}});
  EXPECT_EQ(allowed(arm_with({}, {{"one", "two"}}, neighbors), {}), expected);
  const std::vector<std::uint32_t> nothing(7, 0);
  EXPECT_EQ(allowed(arm_with(nothing, {}, {{{"trunk", 1}, {"four"}}}), {}), (std::set<Names>{{"trunk", "four"}}));
  const Model model = arm_with(nothing, {}, {{{"trunk", 1}, {"four"}}});
  const InnerPairs inner(model, colliding_shapes(model), {});
  EXPECT_FALSE(inner.may_touch(0, 6));
  EXPECT_TRUE(inner.may_touch(1, 6));
}

TEST(InnerPairs, UnknownShapeOfAnAllowedPairIsNamed) {
  const auto error = [](const AllowedPairs& pairs) {
    return fixtures::error_of([&] { allowed(arm_with({}, {}, pairs), {}); });
  };
  EXPECT_TRUE(fixtures::says(error({{{"trunk", 2}, {"one"}}}), {"allowed pair", "'trunk'", "2"}));
  EXPECT_TRUE(fixtures::says(error({{{"trunk", 1}, {"onw"}}}), {"allowed pair", "'onw'", "'one'"}));
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
