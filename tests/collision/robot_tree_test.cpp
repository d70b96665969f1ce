// Which shapes hang together in a robot's tree, how deep it may be, and where the spheres are that it is made for.
#include "murosimf/collision/robot_tree.h"

#include <functional>
#include <gtest/gtest.h>
#include <set>

#include "tests/fixtures.h"

namespace murosimf::collision {
namespace {

using fixtures::difference;
using fixtures::placed;

Chain limb(const std::string& name, const Vec3d& at, const Vec3d& along) {
  return Chain{}
      .translation(at, name + "_upper")
      .with(properties::shapes, {placed(Sphere{0.03})})
      .revolute(name + "_joint", {0, 1, 0})
      .translation(along, name + "_lower")
      .with(properties::shapes, {placed(Sphere{0.03})});
}

/// The robot of the paper's Fig. 5: a body, two arms and two legs with one joint each, a head with a camera.
Model robot_of_figure_5() {
  const Chain head = Chain{}
                         .translation({0, 0, 0.3}, "head")
                         .with(properties::shapes, {placed(Sphere{0.06})})
                         .translation({0.05, 0, 0}, "camera")
                         .endpoint();
  return Model("figure_5", Chain{}
                               .base("body")
                               .with(properties::shapes, {placed(Box{{0.05, 0.08, 0.1}})})
                               .fork(limb("left_arm", {0, 0.2, 0.15}, {0, 0, -0.2}),
                                     limb("right_arm", {0, -0.2, 0.15}, {0, 0, -0.2}),
                                     limb("left_leg", {0, 0.06, -0.15}, {0, 0, -0.2}),
                                     limb("right_leg", {0, -0.06, -0.15}, {0, 0, -0.2}), head));
}

/// The leaves below every inner node of a tree, by the names of their objects.
std::set<std::set<std::string>> groups(const Model& model) {
  const auto shapes = colliding_shapes(model);
  const geometry::TreeLayout layout = robot_tree(model, shapes);
  const int inner = static_cast<int>(layout.children.size());
  std::set<std::set<std::string>> result;
  const std::function<std::set<std::string>(int)> below = [&](int node) -> std::set<std::string> {
    if (node >= inner) return {model.objects()[static_cast<std::size_t>(shapes[node - inner].object)].name};
    std::set<std::string> both;
    for (const int child : layout.children[node]) both.merge(below(child));
    result.insert(both);
    return both;
  };
  if (layout.leaves > 0) below(0);
  return result;
}

// Rule (paper 5.1, Fig. 5): ten bodies make nineteen nodes; the camera and the joints are gone; each limb is a node of
// its own and the body a leaf.
TEST(RobotTree, OfThePapersFigure5) {
  const Model model = robot_of_figure_5();
  const auto shapes = colliding_shapes(model);
  EXPECT_EQ(shapes.size(), 10u);
  EXPECT_EQ(robot_tree(model, shapes).children.size(), 9u);
  const auto found = groups(model);
  EXPECT_EQ(found.size(), 9u);
  for (const std::string limb : {"left_arm", "right_arm", "left_leg", "right_leg"}) {
    EXPECT_TRUE(found.count({limb + "_upper", limb + "_lower"})) << limb;
  }
  // by radii: legs 0.19 m, body and arm 0.24 m; body and head would be 0.25 m, arm and head 0.26 m
  EXPECT_TRUE(found.count({"left_leg_upper", "left_leg_lower", "right_leg_upper", "right_leg_lower"}));
  EXPECT_TRUE(found.count({"body", "left_arm_upper", "left_arm_lower"}));
}

TEST(RobotTree, OfABallIsOneLeaf) {
  const Model ball = fixtures::ball_model(0.1, 0.4);
  const auto layout = robot_tree(ball, colliding_shapes(ball));
  EXPECT_EQ(layout.leaves, 1);
  EXPECT_TRUE(layout.children.empty());
}

TEST(RobotTree, OfAModelWithoutShapesIsEmpty) {
  const Model model("bare", Chain{}.base().with(properties::mass, 1.0));
  EXPECT_EQ(robot_tree(model, colliding_shapes(model)).leaves, 0);
}

// Rule: the shapes of one body stay together, in a tree of their own.
TEST(RobotTree, KeepsShapesOfOneBodyTogether) {
  Chain chain;
  chain.base("body").with(properties::shapes,
                          {placed(Sphere{0.1}), placed(Sphere{0.1}, {1, 0, 0}), placed(Sphere{0.1}, {2, 0, 0})});
  chain.translation({1, 0, 0.01}, "near").with(properties::shapes, {placed(Sphere{0.1})});
  const auto found = groups(Model("brush", chain));
  EXPECT_EQ(found, (std::set<std::set<std::string>>{{"body"}, {"body", "near"}}));
}

/// A snake of balls in a row, one joint between neighbors.
Model snake(int balls) {
  Chain chain;
  chain.base().with(properties::shapes, {placed(Sphere{0.1})});
  for (int i = 1; i < balls; ++i) {
    chain.translation({0.2, 0, 0}).revolute("j" + std::to_string(i), {0, 1, 0});
    chain.with(properties::shapes, {placed(Sphere{0.1})});
  }
  return Model("snake", chain);
}

// Rule: no tree is deeper than traversals can go. The way to the last of n links is n - 1 nodes long; a snake of more is
// split like a field, in halves.
TEST(RobotTree, OfALongSnakeIsShallow) {
  const auto depth = [](int balls) {
    const Model model = snake(balls);
    return robot_tree(model, colliding_shapes(model)).depth();
  };
  EXPECT_EQ(depth(7), 6);
  EXPECT_EQ(depth(geometry::TreeLayout::most_depth + 1), geometry::TreeLayout::most_depth);
  EXPECT_EQ(depth(geometry::TreeLayout::most_depth + 2), 7);
  EXPECT_EQ(depth(300), 9);
}

// Rule: a fork has no place of its own; its branches are joined with what stands before it, the nearest first. Here
// the left arm is nearer to the trunk than to the right arm.
TEST(RobotTree, BranchesOfAForkAreJoinedWithWhatStandsBeforeIt) {
  Chain chain;
  chain.base("trunk").with(properties::shapes, {placed(Sphere{0.1})});
  chain.fork(Chain{}.translation({0, 0.15, 0}, "left").with(properties::shapes, {placed(Sphere{0.05})}),
             Chain{}.translation({0, -0.6, 0}, "right").with(properties::shapes, {placed(Sphere{0.05})}));
  EXPECT_EQ(groups(Model("two arms", chain)),
            (std::set<std::set<std::string>>{{"trunk", "left"}, {"trunk", "left", "right"}}));
}

// By hand: the shape lies at x = 0.3 of a body that stands 0.5 m above the base and is turned by a right angle about z.
TEST(RobotTree, SpheresAreThoseOfThePostureAtRest) {
  Chain chain;
  chain.base().with(properties::shapes, {placed(Sphere{0.07}, {0.1, 0.2, 0})});
  chain.translation({0, 0.4, 0.5}).rotation(rotation_z(pi / 2)).revolute("joint", {0, 1, 0});
  chain.with(properties::shapes, {placed(Sphere{0.02}, {0.3, 0, 0})});
  const Model model("bent", chain);
  const auto spheres = rest_spheres(model, colliding_shapes(model));
  ASSERT_EQ(spheres.size(), 2U);
  EXPECT_LT(difference(spheres[0].center, {0.1, 0.2, 0}), 1e-15);
  EXPECT_EQ(spheres[0].radius, 0.07);
  EXPECT_LT(difference(spheres[1].center, {0, 0.7, 0.5}), 1e-15);
  EXPECT_EQ(spheres[1].radius, 0.02);
}

// Rule: of pairs that fit into equal spheres, those are joined that the model names first; the body comes before what
// hangs on it. Balls in a row, 0.5 m apart.
TEST(RobotTree, OfEqualPairsTheFirstAreJoined) {
  const auto arm = [](const std::string& name, double x) {
    return Chain{}.translation({x, 0, 0}, name).with(properties::shapes, {placed(Sphere{0.125})});
  };
  Chain bare, body;
  bare.base().fork(arm("a", -0.5), arm("b", 0), arm("c", 0.5));
  EXPECT_EQ(groups(Model("bare", bare)), (std::set<std::set<std::string>>{{"a", "b"}, {"a", "b", "c"}}));
  body.base("body").with(properties::shapes, {placed(Sphere{0.125})}).fork(arm("a", 0.5), arm("b", 1));
  EXPECT_EQ(groups(Model("body", body)), (std::set<std::set<std::string>>{{"body", "a"}, {"body", "a", "b"}}));
}

}  // namespace
}  // namespace murosimf::collision
