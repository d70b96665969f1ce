#include "murosimf/model/model.h"

#include <limits>

#include <gtest/gtest.h>

#include "tests/fixtures.h"

#include "murosimf/dynamics/motion_properties.h"

namespace murosimf {
namespace {

using fixtures::difference;
using fixtures::error_of;
using fixtures::says;
using namespace properties;

std::string refusal(const Chain& chain) {
  return error_of([&] { Model("robot", chain); });
}

// Rule: joints are all revolute and prismatic objects; bodies all with mass or shape, on whatever object they sit.
TEST(ModelTest, JointsAndBodies) {
  const Model model("m", Chain{}
                             .base("b")                     // 0
                             .revolute("hinge", {1, 0, 0})  // 1
                             .translation({1, 0, 0})
                             .with(mass, 1)  // 2
                             .prismatic("slider", {1, 0, 0})
                             .with(shapes, {})  // 3
                             .rotation({1, 0, 0}, 1)
                             .with(joint_damping, 0.1)  // 4
                             .endpoint("tip")
                             .with(mass, 1)
                             .with(shapes, {}));  // 5
  EXPECT_EQ(std::vector<int>(model.joints().begin(), model.joints().end()), (std::vector<int>{1, 3}));
  EXPECT_EQ(std::vector<int>(model.bodies().begin(), model.bodies().end()), (std::vector<int>{2, 3, 5}));
  EXPECT_EQ(model.having(mass), (std::vector<int>{2, 5}));
  EXPECT_EQ(model.having(joint_damping), (std::vector<int>{4}));
  EXPECT_TRUE(model.having(servo).empty());
  EXPECT_EQ(model.size(), 6);
  EXPECT_EQ(model.name(), "m");
}

// Rule: a center of mass or an inertia means nothing without a mass, and places must be numbers.
TEST(ModelTest, WhatMeansNothingIsRefused) {
  EXPECT_THROW(Model("m", Chain{}.base("b").with(center_of_mass, {1, 0, 0})), SetupError);
  EXPECT_THROW(Model("m", Chain{}.base("b").with(inertia, diagonal(1.0))), SetupError);
  EXPECT_THROW(Model("m", Chain{}.base("b").with(mass, 1).with(center_of_mass, {std::nan(""), 0, 0})), SetupError);
  EXPECT_THROW(Model("m", Chain{}.base("b").translation({std::nan(""), 0, 0})), SetupError);
}

// Rule: objects without a name get one from kind and index; aliases find the same object as the name.
TEST(ModelTest, Names) {
  const Model model("m", Chain{}.base("b").translation({1, 0, 0}).endpoint("tip").alias("hand").alias("tip"));
  EXPECT_EQ(model.objects()[1].name, "translation_1");
  EXPECT_EQ(model.object_index("translation_1"), 1);
  EXPECT_EQ(model.object_index("tip"), 2);
  EXPECT_EQ(model.object_index("hand"), 2);
  EXPECT_EQ(model.find_object("nobody"), std::nullopt);
  EXPECT_EQ(model.object_names().size(), 4u);
  EXPECT_TRUE(says(error_of([&] { (void)model.object_index("hant"); }),
                   {"model 'm'", "unknown object 'hant'", "did you mean 'hand'?"}));
}

// Rule: a model begins with its only base.
TEST(ModelTest, ExactlyOneBase) {
  EXPECT_TRUE(says(refusal(Chain{}), {"model 'robot'", "must begin with a base"}));
  EXPECT_TRUE(says(refusal(Chain{}.translation({1, 0, 0}).base()), {"must begin with a base"}));
  EXPECT_TRUE(says(refusal(Chain{}.base().base("again")), {"model 'robot'", "second base", "'again'"}));
  const Chain hidden = Chain{}.base("hidden");
  EXPECT_TRUE(says(refusal(Chain{}.base().fork(Chain{}.endpoint(), hidden)), {"second base", "'hidden'"}));
  EXPECT_EQ(refusal(Chain{}.base()), "no error");
}

// Rule: a name, given or made up or an alias, means one object.
TEST(ModelTest, NamesAreUnique) {
  EXPECT_TRUE(says(refusal(Chain{}.base("a").endpoint("a")), {"model 'robot'", "two objects", "'a'"}));
  EXPECT_TRUE(says(refusal(Chain{}.base("a").endpoint("b").alias("a")), {"two objects", "'a'"}));
  EXPECT_TRUE(says(refusal(Chain{}.base("translation_1").translation({1, 0, 0})), {"two objects", "'translation_1'"}));
  const Chain leg = Chain{}.revolute("knee", {0, 1, 0});
  EXPECT_TRUE(says(refusal(Chain{}.base().fork(leg, leg)), {"two objects", "'knee'"}));
}

// Rule: masses are positive and finite; the message names the object and the number.
TEST(ModelTest, ImpossibleMasses) {
  const auto with_mass = [](double m) { return refusal(Chain{}.base().endpoint("foot").with(mass, m)); };
  EXPECT_TRUE(says(with_mass(-0.5), {"model 'robot'", "object 'foot'", "mass -0.5 kg", "not positive"}));
  EXPECT_TRUE(says(with_mass(0), {"object 'foot'", "mass 0 kg"}));
  EXPECT_TRUE(says(with_mass(std::numeric_limits<double>::quiet_NaN()), {"object 'foot'"}));
  EXPECT_TRUE(says(with_mass(std::numeric_limits<double>::infinity()), {"object 'foot'"}));
  EXPECT_EQ(with_mass(1e-6), "no error");
}

// Rule: inertias are positive definite: each of the three minors is looked at.
TEST(ModelTest, ImpossibleInertias) {
  const auto with_inertia = [](const SymMat3d& I) {
    return refusal(Chain{}.base().endpoint("foot").with(mass, 1).with(inertia, I));
  };
  EXPECT_TRUE(says(with_inertia({-1, 1, 1, 0, 0, 0}), {"model 'robot'", "object 'foot'", "not positive definite"}));
  EXPECT_NE(with_inertia({1, -1, 1, 0, 0, 0}), "no error");
  EXPECT_NE(with_inertia({1, 1, -1, 0, 0, 0}), "no error");
  EXPECT_NE(with_inertia({1, -1, -1, 0, 0, 0}), "no error");  // determinant 1
  EXPECT_NE(with_inertia({1, 1, 1, 1.1, 0, 0}), "no error");
  EXPECT_NE(with_inertia({1, 1, 1, 0, 1.1, 0}), "no error");
  EXPECT_NE(with_inertia({1, 1, 1, 0, 0, 1.1}), "no error");
  EXPECT_NE(with_inertia({1, 1, 1, -0.9, -0.9, -0.9}), "no error");  // every pair is fine, all three are not
  EXPECT_NE(with_inertia({0, 0, 0, 0, 0, 0}), "no error");
  EXPECT_NE(with_inertia({std::numeric_limits<double>::quiet_NaN(), 1, 1, 0, 0, 0}), "no error");
  EXPECT_EQ(with_inertia({1e-9, 1e-9, 1e-9, 1e-10, 0, 0}), "no error");  // a small screw
}

// Rule: constants are found by object; null where there is none.
TEST(ModelTest, Constants) {
  const Model model = fixtures::two_legged();
  EXPECT_EQ(*model.find(mass, 0), 1.4);
  EXPECT_EQ(*model.find(mass, model.object_index("left_knee")), 0.3);
  EXPECT_EQ(model.find(mass, model.object_index("left_ankle")), nullptr);
  EXPECT_NEAR(model.tree().mass, 3.0, 1e-15);
  EXPECT_EQ(model.joints().size(), 8u);
  EXPECT_EQ(model.having(sole).size(), 2u);
}

// Law: placement is where an object stands in its link: the composition of all fixed objects between. A joint and the
// base stand at their own origin. Tolerance: rounding of two products.
TEST(ModelTest, Placement) {
  const Model model("m", Chain{}
                             .base("b")
                             .translation({1, 0, 0})
                             .revolute("hinge", {0, 0, 1})
                             .translation({0, 2, 0})
                             .rotation({0, 0, 1}, pi / 2)
                             .translation({0, 0.5, 0}, "end"));
  const FixedObject end = model.placement(model.object_index("end"));
  EXPECT_EQ(end.link, 1);
  EXPECT_EQ(end.object, model.object_index("end"));
  EXPECT_LT(difference(end.offset, {-0.5, 2, 0}), 1e-15);
  EXPECT_LT(difference(end.turn, rotation_z(pi / 2)), 1e-16);
  EXPECT_TRUE(end.turned);
  const FixedObject hinge = model.placement(model.object_index("hinge"));
  EXPECT_EQ(hinge.link, 1);
  EXPECT_EQ(difference(hinge.offset, {}), 0);
  EXPECT_FALSE(hinge.turned);
  EXPECT_EQ(model.placement(0).link, 0);
}

}  // namespace
}  // namespace murosimf
