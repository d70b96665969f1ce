#include "murosimf/collision/compound.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <set>

#include "murosimf/collision/ground_points.h"
#include "murosimf/files/data_path.h"
#include "murosimf/multibody/kinematics.h"
#include "murosimf/robot/robot_reader.h"
#include "tests/geometry/volume_fixtures.h"

namespace murosimf::collision {
namespace {

using fixtures::Dice;
using fixtures::placed;

const Model& kid21() {
  static const ModelPtr model = robot::read_robot(files::find_data_file("kid21", "models", ".xml")).model;
  return *model;
}

/// A robot in a random posture somewhere.
struct Posed {
  explicit Posed(const Model& model)
      : tree(model.tree()), q(static_cast<std::size_t>(model.size())), r(q.size()), R(q.size()) {}
  void pose(Dice& dice, double away) {
    for (double& angle : q) angle = dice.uniform(-3, 3);
    r[0] = dice.vector(away);
    R[0] = dice.turn();
    multibody::poses<double>(tree, q, r, R);
  }
  const Tree& tree;
  std::vector<double> q;
  std::vector<Vec3d> r;
  std::vector<Mat3d> R;
};

// Law: the root holds the surface of every shape, in 10000 random postures; so does the sphere of the entity's reach.
TEST(Compound, EnclosesItsShapes) {
  Dice dice("enclose");
  const Model& model = kid21();
  const double rounding = 1e-12;
  for (const auto volume : geometry::volume_names()) {
    for (const bool structured : {true, false}) {
      Compound compound(model, {std::string(volume), structured});
      std::vector<std::vector<Vec3d>> samples;
      for (const CollidingShape& shape : compound.shapes()) {
        samples.push_back(fixtures::surface_samples(shape.placed.shape));
      }
      Posed robot(model);
      double worst = -1, worst_reach = -1;
      for (int i = 0; i < 1250; ++i) {
        robot.pose(dice, 1);
        compound.refit(robot.r, robot.R);
        for (std::size_t k = 0; k < samples.size(); ++k) {
          const Transformd at = compound.pose(static_cast<int>(k), robot.r, robot.R);
          for (std::size_t n = static_cast<std::size_t>(i); n < samples[k].size(); n += 1250) {
            const Vec3d p = at.position + at.orientation * samples[k][n];
            const double out =
                std::visit([&](const auto& tree) { return fixtures::outside(tree.volume(0), p); }, compound.tree());
            worst = std::fmax(worst, out);
            worst_reach = std::fmax(worst_reach, norm(p - robot.r[0]) - compound.reach());
          }
        }
      }
      EXPECT_LT(worst, rounding) << volume;
      EXPECT_LT(worst_reach, rounding);
    }
  }
}

/// All pairs of shapes of two robots that the trees find.
std::set<std::pair<int, int>> pairs(const Compound& a, const Compound& b) {
  std::set<std::pair<int, int>> result;
  for_pairs(a, b, [&](int i, int j) { return result.emplace(i, j).second; });
  return result;
}

// Law: in 10000 random postures of two robots, of every pair of kinds, the tree finds the leaves that brute force
// finds, and with them every pair of shapes that share a point of their surfaces' samples.
TEST(Compound, TreesFindWhatBruteForceFinds) {
  Dice dice("two robots");
  const Model& model = kid21();
  std::size_t found = 0;
  for (const auto volume_a : geometry::volume_names()) {
    for (const auto volume_b : geometry::volume_names()) {
      Compound a(model, {std::string(volume_a), true}), b(model, {std::string(volume_b), dice.chance(0.5)});
      Posed one(model), other(model);
      for (int i = 0; i < 625; ++i) {
        one.pose(dice, 0.2);
        other.pose(dice, 0.2);
        a.refit(one.r, one.R);
        b.refit(other.r, other.R);
        std::set<std::pair<int, int>> by_force;
        std::visit(
            [&](const auto& tree_a, const auto& tree_b) {
              geometry::for_pairs_brute_force(tree_a, tree_b,
                                              [&](int x, int y) { return by_force.emplace(x, y).second; });
            },
            a.tree(), b.tree());
        ASSERT_EQ(pairs(a, b), by_force) << volume_a << ' ' << volume_b;
        found += by_force.size();
      }
    }
  }
  EXPECT_GT(found, 10000u);
}

/// True if one of the points of the surface of A is in B.
bool one_inside(const std::vector<Vec3d>& points, const Transformd& at_a, const Shape& b, const Transformd& at_b) {
  return std::any_of(points.begin(), points.end(), [&](const Vec3d& point) {
    const Vec3d p = at_a.position + at_a.orientation * point;
    return fixtures::outside(b, transposed_times(at_b.orientation, p - at_b.position)) < 0;
  });
}

/// A few hundred points of the surface of every shape.
std::vector<std::vector<Vec3d>> surfaces(const Compound& compound) {
  std::vector<std::vector<Vec3d>> result;
  for (const CollidingShape& shape : compound.shapes()) {
    const auto all = fixtures::surface_samples(shape.placed.shape);
    auto& some = result.emplace_back();
    for (std::size_t i = 0; i < all.size(); i += 37) some.push_back(all[i]);
  }
  return result;
}

// Law: shapes that overlap are among the pairs that the tree finds.
TEST(Compound, TreesMissNoOverlap) {
  Dice dice("overlaps");
  const Model& model = kid21();
  int overlaps = 0;
  for (const auto volume : geometry::volume_names()) {
    Compound a(model, {std::string(volume), true}), b = a;
    const auto samples = surfaces(a);
    Posed one(model), other(model);
    for (int i = 0; i < 5; ++i) {
      one.pose(dice, 0.1);
      other.pose(dice, 0.1);
      a.refit(one.r, one.R);
      b.refit(other.r, other.R);
      const auto found = pairs(a, b);
      for (int x = 0; x < static_cast<int>(a.shapes().size()); ++x) {
        for (int y = 0; y < static_cast<int>(b.shapes().size()); ++y) {
          if (!one_inside(samples[x], a.pose(x, one.r, one.R), b.shapes()[y].placed.shape,
                          b.pose(y, other.r, other.R))) {
            continue;
          }
          ++overlaps;
          EXPECT_TRUE(found.count({x, y})) << volume << ' ' << x << ' ' << y;
        }
      }
    }
  }
  EXPECT_GT(overlaps, 20);
}

// Rule: one list of shapes for contact with the ground and with bodies.
TEST(Compound, HasTheShapesThatTouchTheGround) {
  const auto ground = ground_shapes(kid21());
  const Compound compound(kid21());
  ASSERT_EQ(compound.shapes().size(), ground.size());
  for (std::size_t i = 0; i < ground.size(); ++i) EXPECT_EQ(compound.shapes()[i].object, ground[i].object);
}

TEST(Compound, OfAModelWithoutShapesReachesNowhere) {
  Compound compound(Model("bare", Chain{}.base().with(properties::mass, 1.0)));
  compound.refit(std::vector<Vec3d>(1), std::vector<Mat3d>(1));
  EXPECT_EQ(compound.reach(), 0);
}

// Rule: one shape of a kind of its own is enough that kinds must be asked for, wherever it stands in the list.
TEST(Compound, KnowsWhetherAllShapesTouchEachOther) {
  const auto all_touch = [](std::size_t unusual, std::uint32_t type, std::uint32_t affinity) {
    Shapes shapes(3, placed(Sphere{0.1}));
    shapes[unusual].contact_type = type;
    shapes[unusual].contact_affinity = affinity;
    return Compound(Model("three", Chain{}.base().with(properties::shapes, shapes))).all_touch();
  };
  for (const std::size_t i : {0U, 1U, 2U}) {
    EXPECT_TRUE(all_touch(i, 1, 1));
    EXPECT_FALSE(all_touch(i, 2, 1));
    EXPECT_FALSE(all_touch(i, 1, 0));
  }
}

// Rule: equal robots share what never changes, and nothing that does; other options are another compound.
TEST(Compound, OfEqualRobotsShareAllButTheirVolumes) {
  const CompoundOptions options{.inner = true, .excluded = {{"head", "torso"}}};
  Compound here(kid21(), options), there(kid21(), options);
  EXPECT_EQ(&here.shapes(), &there.shapes());
  EXPECT_EQ(&here.inner_pairs(), &there.inner_pairs());
  Posed robot(kid21());
  Dice dice("share");
  robot.pose(dice, 1);
  here.refit(robot.r, robot.R);
  robot.pose(dice, 1);
  there.refit(robot.r, robot.R);
  EXPECT_NE(here.around().center.x, there.around().center.x);

  const Compound without(kid21(), {}), less(kid21(), {.inner = true});
  EXPECT_TRUE(without.inner_pairs().off());
  EXPECT_NE(&less.inner_pairs(), &here.inner_pairs()) << "its limbs may touch others";
  EXPECT_EQ(Compound(kid21(), {"obb", false}).tree().index(), 2U);
  EXPECT_EQ(here.tree().index(), 0U);
}

TEST(Compound, UnknownVolumeNamesTheNearest) {
  EXPECT_TRUE(fixtures::says(fixtures::error_of([] { Compound(kid21(), {"capsul", true}); }), {"'capsule'"}));
}

}  // namespace
}  // namespace murosimf::collision
