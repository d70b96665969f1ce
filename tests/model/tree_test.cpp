#include "murosimf/model/tree.h"

#include <gtest/gtest.h>

#include "tests/fixtures.h"

namespace murosimf {
namespace {

using fixtures::difference;
using namespace properties;

/// Place of an object in the frame of its link, by walking up to the link.
void place_in_link(const Model& model, int object, Vec3d& offset, Mat3d& turn) {
  offset = {};
  turn = {};
  for (int i = object;; i = model.objects()[i].parent) {
    const Object& o = model.objects()[i];
    if (o.kind == Kind::base || o.is_joint()) return;
    if (o.kind == Kind::translation) offset += o.vector;
    if (o.kind == Kind::rotation) {
      offset = o.turn * offset;
      turn = o.turn * turn;
    }
  }
}

// Rule: one link per base or joint, parents first; every object moves with the nearest joint above it.
TEST(TreeTest, LinksAndTheirParents) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Model model = fixtures::random_model(seed);
    const Tree& tree = model.tree();
    ASSERT_EQ(tree.links.size(), model.joints().size() + 1);
    ASSERT_EQ(tree.fixed.size() + tree.links.size(), static_cast<std::size_t>(model.size()));
    EXPECT_EQ(tree.links[0].parent, -1);
    EXPECT_EQ(tree.links[0].kind, LinkKind::base);
    for (int i = 0; i < model.size(); ++i) {
      int above = i;
      while (above > 0 && !model.objects()[above].is_joint()) above = model.objects()[above].parent;
      EXPECT_EQ(tree.links[tree.link_of[i]].object, above);
    }
    for (std::size_t l = 1; l < tree.links.size(); ++l) {
      const Link& link = tree.links[l];
      EXPECT_LT(link.parent, static_cast<int>(l));
      EXPECT_EQ(link.parent, tree.link_of[model.objects()[link.object].parent]);
      EXPECT_EQ(link.kind == LinkKind::revolute, model.objects()[link.object].kind == Kind::revolute);
    }
  }
}

// Law: place of joints and fixed objects in their link = composition of what lies between. Tolerance: up to ten
// products of rotations and shifts of 0.3 m.
TEST(TreeTest, PlacesInTheLink) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Model model = fixtures::random_model(seed);
    for (const FixedObject& fixed : model.tree().fixed) {
      Vec3d offset;
      Mat3d turn;
      place_in_link(model, fixed.object, offset, turn);
      EXPECT_LT(difference(fixed.offset, offset), 3e-15);
      EXPECT_LT(difference(fixed.turn, turn), 3e-15);
      EXPECT_TRUE(fixed.turned || difference(turn, Mat3d{}) == 0);
    }
    for (std::size_t l = 1; l < model.tree().links.size(); ++l) {
      const Link& link = model.tree().links[l];
      Vec3d offset;
      Mat3d turn;
      place_in_link(model, model.objects()[link.object].parent, offset, turn);
      EXPECT_LT(difference(link.offset, offset), 3e-15);
      EXPECT_LT(difference(link.turn, turn), 3e-15);
      EXPECT_TRUE(link.turned || difference(turn, Mat3d{}) == 0);
    }
  }
}

// Law: a link has the mass, first and second moment of all bodies fixed to it (parallel-axis theorem). The sum is
// taken about the link's origin here, where the tree merges about a moving center. Tolerance: rounding of up to ten
// masses of 2 kg within 2 m.
TEST(TreeTest, MergedMassesKeepTheirMoments) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Model model = fixtures::random_model(seed);
    double total = 0;
    for (std::size_t l = 0; l < model.tree().links.size(); ++l) {
      const Link& link = model.tree().links[l];
      double m = 0;
      Vec3d first;
      SymMat3d second;
      for (const int i : model.having(mass)) {
        if (model.tree().link_of[i] != static_cast<int>(l)) continue;
        Vec3d offset;
        Mat3d turn;
        place_in_link(model, i, offset, turn);
        const double mi = *model.find(mass, i);
        const Vec3d* com = model.find(center_of_mass, i);
        const SymMat3d* I = model.find(inertia, i);
        const Vec3d at = com ? offset + turn * *com : offset;
        m += mi;
        first += mi * at;
        second += mi * inertia_of_point(at);
        if (I) second += rotated(turn, *I);
      }
      total += m;
      EXPECT_NEAR(link.mass, m, 1e-14);
      EXPECT_LT(difference(link.mass * link.com, first), 1e-14);
      EXPECT_LT(difference(link.inertia + link.mass * inertia_of_point(link.com), second), 2e-14);
    }
    EXPECT_NEAR(model.tree().mass, total, 1e-13);
  }
}

// Law: two points of 1 kg, 2 m apart, are a dumbbell: center between them, 2 kg m^2 across, 0 along. Exact.
TEST(TreeTest, Dumbbell) {
  const Model model("dumbbell", Chain{}.base().with(mass, 1).translation({2, 0, 0}).with(mass, 1));
  const Link& link = model.tree().links[0];
  EXPECT_EQ(link.mass, 2);
  EXPECT_EQ(difference(link.com, {1, 0, 0}), 0);
  EXPECT_EQ(difference(link.inertia, {0, 2, 2, 0, 0, 0}), 0);
}

// Rule: joints along a coordinate axis are recognised, whatever the length of the given axis; others are general,
// also those against an axis.
TEST(TreeTest, AxisKinds) {
  const Model model("axes", Chain{}
                                .base()
                                .revolute("x", {2, 0, 0})
                                .revolute("y", {0, 0.5, 0})
                                .prismatic("z", {0, 0, 1})
                                .revolute("against", {0, -1, 0})
                                .revolute("oblique", {1, 1, 0}));
  const auto& links = model.tree().links;
  ASSERT_EQ(links.size(), 6u);
  EXPECT_EQ(links[1].axis_kind, AxisKind::x);
  EXPECT_EQ(links[2].axis_kind, AxisKind::y);
  EXPECT_EQ(links[3].axis_kind, AxisKind::z);
  EXPECT_EQ(links[4].axis_kind, AxisKind::general);
  EXPECT_EQ(links[5].axis_kind, AxisKind::general);
  EXPECT_NEAR(norm(links[5].axis), 1, 2e-16);
}

}  // namespace
}  // namespace murosimf
