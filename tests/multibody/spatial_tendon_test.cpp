/// spatial_tendon_test - lengths and slopes of tendons through points of bodies, against closed forms and differences.
#include "murosimf/multibody/spatial_tendon.h"

#include <cmath>

#include <gtest/gtest.h>

#include "murosimf/math/random.h"
#include "murosimf/model/properties.h"
#include "tests/fixtures.h"

namespace murosimf::multibody {
namespace {

using Part = SpatialTendon::Part;

Part point(const std::string& object, const Vec3d& at) { return {{object, {at, {}}}}; }
Part wheel(const std::string& object, const Vec3d& at, double radius, bool cylinder) {
  return {{object, {at, rotation_x(0.4)}}, radius, cylinder};
}

/// An arm of two oblique hinges and a slide, and a hinge beside it.
Model arm() {
  Chain one = Chain{}
                  .translation({0.1, 0.2, 0.3}, "step")
                  .revolute("i", {0.3, 1, 0.2})
                  .rotation(rotation_z(0.5), "turn")
                  .translation({0, 0, 0.4}, "bone")
                  .revolute("j", {1, 0.1, 0})
                  .prismatic("k", {0, 0.6, 0.8});
  Chain other = Chain{}.revolute("m", {0, 0, 1}).translation({0.3, 0, 0}, "hand");
  return {"arm", Chain{}.base("body").with(properties::mass, 1.0).fork({one, other})};
}

struct Found {
  double length;
  std::vector<double> slopes;
};

Found find(const Model& model, const SpatialTendon& tendon, const std::vector<double>& q) {
  const TendonPath path(model, tendon);
  Found found{0, std::vector<double>(path.joints().size())};
  found.length = path.look(q, found.slopes);
  return found;
}

// Two points at the distances a and b from a hinge: L^2 = a^2 + b^2 - 2 a b cos(q), dL/dq = a b sin(q) / L.
TEST(SpatialTendon, ObeysTheLawOfCosines) {
  const Model model = arm();
  const SpatialTendon tendon{{{1, {point("body", {0.5, 0, 0.1}), point("hand", {0, 0, 0.1})}}}};
  std::vector<double> q(static_cast<std::size_t>(model.size()));
  for (const double angle : {0.2, 1.0, -2.0}) {
    q[model.object_index("m")] = angle;
    const auto [length, slopes] = find(model, tendon, q);
    const double expected = std::sqrt(0.25 + 0.09 - 2 * 0.5 * 0.3 * std::cos(angle));
    EXPECT_NEAR(length, expected, 1e-14);
    ASSERT_EQ(slopes.size(), 1U);
    EXPECT_NEAR(slopes[0], 0.5 * 0.3 * std::sin(angle) / expected, 1e-14);
  }
}

// The slopes are those of the length, whatever the string runs through and around, with pulleys.
TEST(SpatialTendon, SlopesAreThoseOfItsLength) {
  const Model model = arm();
  const RandomStream random(5, "strings");
  std::uint64_t drawn = 0;
  Part sided = wheel("hand", {0.05, 0, 0}, 0.05, true);
  sided.side = SpatialTendon::Place{"step", {{0.3, 0.1, -0.2}, {}}};
  const SpatialTendon tendon{
      {{1, {point("body", {0.5, 0, 0.1}), wheel("j", {0, 0.05, 0}, 0.08, false), point("k", {0.1, 0.2, 0.1})}},
       {2, {point("k", {0.1, 0.2, 0.1}), sided, point("body", {0, -0.3, 0}), point("bone", {0.1, 0.1, 0})}},
       {3, {point("step", {0.5, -0.5, 0}), wheel("bone", {0, 0, -0.05}, 0.1, true), point("j", {-0.3, 0.1, 0.2})}}}};
  int touched = 0;
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<double> q(static_cast<std::size_t>(model.size()));
    for (const int joint : model.joints()) q[joint] = random.uniform(drawn++, -1.5, 1.5);
    const TendonPath path(model, tendon);
    ASSERT_EQ(path.joints().size(), 4U);
    const Found found = find(model, tendon, q);
    for (std::size_t i = 0; i < 4; ++i) {
      constexpr double step = 1e-6;
      auto more = q, less = q;
      more[path.joints()[i]] += step;
      less[path.joints()[i]] -= step;
      const double slope = (find(model, tendon, more).length - find(model, tendon, less).length) / (2 * step);
      EXPECT_NEAR(found.slopes[i], slope, 1e-6) << "joint " << i << ", trial " << trial;
    }
    SpatialTendon bare = tendon;  // without obstacles
    for (auto& branch : bare.branches) std::erase_if(branch.parts, [](const Part& part) { return part.radius > 0; });
    touched += find(model, bare, q).length < found.length - 1e-6;
  }
  EXPECT_GT(touched, 10) << "the obstacles matter";
}

TEST(SpatialTendon, OnlyJointsBetweenItsPointsChangeIt) {
  const Model model = arm();
  const TendonPath path(model, {{{1, {point("j", {0.1, 0, 0}), point("k", {0, 0, 0.2})}}}});
  ASSERT_EQ(path.joints().size(), 1U);
  EXPECT_EQ(path.joints()[0], model.object_index("k"));
}

TEST(SpatialTendon, NamesWhatIsWrong) {
  const Model model = arm();
  const auto complaint = [&](const SpatialTendon& tendon) {
    return fixtures::error_of([&] { const TendonPath path(model, tendon); });
  };
  const Part a = point("body", {}), b = point("hand", {}), wheel_of_j = wheel("j", {}, 0.1, false);
  EXPECT_TRUE(fixtures::says(complaint({{{1, {a, point("hamd", {})}}}}), {"'hamd'", "'hand'"}));
  EXPECT_TRUE(fixtures::says(complaint({{{0, {a, b}}}}), {"divisor 0"}));
  EXPECT_TRUE(fixtures::says(complaint({{{1, {wheel_of_j, b}}}}), {"an obstacle needs a point before and behind it"}));
  EXPECT_TRUE(fixtures::says(complaint({{{1, {a, wheel_of_j}}}}), {"a branch begins and ends with a point"}));
  EXPECT_TRUE(fixtures::says(complaint({{{1, {a, wheel("j", {}, -1, false), b}}}}), {"the radius -1 of an obstacle"}));
  EXPECT_TRUE(fixtures::says(complaint({}), {"it has no branch"}));
}

}  // namespace
}  // namespace murosimf::multibody
