// Which joints follow a rate, and which of them turn for ever.
#include "murosimf/dynamics/velocity_joints.h"

#include <gtest/gtest.h>

#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/model/properties.h"
#include "tests/dynamics/part.h"
#include "tests/fixtures.h"

namespace murosimf::dynamics {
namespace {

const Servo of_rate{.law = "ideal_pd", .velocity_gain = 0.4};
const Servo of_position{.law = "ideal_pd", .position_gain = 5, .velocity_gain = 0.4};

/// Of all kinds; a lift and a turret that follow a rate, but not for ever.
Chain joints() {
  return Chain{}
      .base("base")
      .revolute("arm", {0, 1, 0})
      .with(properties::servo, of_position)
      .revolute("wheel", {0, 1, 0})
      .with(properties::servo, of_rate)
      .prismatic("lift", {0, 0, 1})
      .with(properties::servo, of_rate)
      .revolute("free", {0, 1, 0})
      .revolute("turret", {0, 0, 1})
      .with(properties::servo, of_rate)
      .with(properties::joint_range, {-6, 6, 0})
      .revolute("reel", {1, 0, 0})
      .with(properties::servo, of_rate);
}

struct Joints : test::Alone<VelocityJoints> {
  Joints() : Alone(joints()) {}
  [[nodiscard]] std::vector<int> of(const std::vector<const char*>& names) const {
    std::vector<int> objects;
    for (const char* name : names) objects.push_back(index(name));
    return objects;
  }
};

TEST(VelocityJoints, AreThoseWhoseServosHaveNoPositionGain) {
  const Joints joints;
  EXPECT_EQ(joints.part->joints(), joints.of({"wheel", "lift", "turret", "reel"}));
  EXPECT_EQ(joints.part->others(), joints.of({"arm", "free"}));
  for (const int i : joints.part->joints()) EXPECT_TRUE(joints.part->contains(i));
  for (const int i : joints.part->others()) EXPECT_FALSE(joints.part->contains(i));
  EXPECT_FALSE(joints.part->contains(0));
}

TEST(VelocityJoints, KnowTheirTargets) {
  Joints joints;
  EXPECT_EQ(joints.part->target(joints.index("lift")), 0) << "no target set";
  joints.object("wheel").set(properties::joint_velocity_target, 4);
  joints.object("reel").set(properties::joint_velocity_target, -3);
  EXPECT_EQ(joints.part->target(joints.index("wheel")), 4);
  EXPECT_EQ(joints.part->target(joints.index("reel")), -3);
  const test::Alone<VelocityJoints> none(Chain{}.base("base").revolute("arm", {0, 1, 0}));
  EXPECT_EQ(none.entity.find(properties::joint_velocity_target), nullptr)
      << "a robot without wheels has no such column";
}

// Rule: whole turns are taken out beyond half a turn, but only where they mean nothing.
TEST(VelocityJoints, EndlessOnesStayWithinATurn) {
  const Joints joints;
  std::vector<double> q(joints.holder.columns.q.size());
  const auto wrapped = [&](double angle) {
    std::fill(q.begin(), q.end(), angle);
    joints.part->wrap(q);
    for (const char* name : {"arm", "lift", "free", "turret"}) EXPECT_EQ(q[joints.index(name)], angle) << name;
    EXPECT_EQ(q[joints.index("wheel")], q[joints.index("reel")]);
    return q[joints.index("wheel")];
  };
  for (const double inside : {0.0, 3.1, -3.1, pi, -pi}) EXPECT_EQ(wrapped(inside), inside);
  EXPECT_NEAR(wrapped(3.2), 3.2 - 2 * pi, 1e-15);
  EXPECT_NEAR(wrapped(-4), -4 + 2 * pi, 1e-15);
  EXPECT_NEAR(wrapped(20), 20 - 6 * pi, 1e-14);
}

}  // namespace
}  // namespace murosimf::dynamics
