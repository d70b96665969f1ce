#include "murosimf/geometry/bounding_tree.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>

#include "murosimf/geometry/any_tree.h"
#include "murosimf/geometry/traversal.h"
#include "tests/geometry/volume_fixtures.h"

namespace murosimf::geometry {
namespace {

using fixtures::Dice;
using PairsFound = std::set<std::pair<int, int>>;

/// Shapes in random places of one object each, and poses of the objects.
struct Cloud {
  Cloud(Dice& dice, int count) : shapes(fixtures::shapes_of_all_kinds()) {
    for (int i = 0; i < count; ++i) {
      parts.push_back({i, &shapes[static_cast<std::size_t>(i) % shapes.size()], {dice.vector(0.1), dice.turn()}});
      spheres.push_back({dice.vector(0.5), 0.2});
    }
    move(dice, 0.5);
  }
  void move(Dice& dice, double size) {
    r.clear();
    R.clear();
    for (std::size_t i = 0; i < parts.size(); ++i) {
      r.push_back(dice.vector(size));
      R.push_back(dice.turn());
    }
  }
  [[nodiscard]] AnyTree tree(std::string_view volume) const {
    return make_tree(volume, parts, split_top_down(spheres));
  }

  std::vector<Shape> shapes;
  std::vector<TreePart> parts;
  std::vector<BoundingSphere> spheres;
  std::vector<Vec3d> r;
  std::vector<Mat3d> R;
};

template <class Found, class Tree>
PairsFound tree_pairs(const Found& find, const Tree& a, const Tree& b) {
  return std::visit(
      [&](const auto& tree_a, const auto& tree_b) {
        PairsFound result;
        find(tree_a, tree_b, [&](int i, int j) {
          EXPECT_TRUE(result.emplace(i, j).second) << "pair found twice";
          return true;
        });
        return result;
      },
      a, b);
}

// Law: the tree finds the same pairs of leaves as testing all of them, for all 16 pairs of kinds.
TEST(BoundingTree, FindsWhatBruteForceFinds) {
  Dice dice("two clouds");
  Cloud one(dice, 20), other(dice, 13);
  std::size_t found = 0;
  for (const auto volume_a : volume_names()) {
    for (const auto volume_b : volume_names()) {
      AnyTree a = one.tree(volume_a), b = other.tree(volume_b);
      for (int i = 0; i < 625; ++i) {
        one.move(dice, 0.7);
        other.move(dice, 0.7);
        std::visit([&](auto& tree) { tree.refit(one.r, one.R); }, a);
        std::visit([&](auto& tree) { tree.refit(other.r, other.R); }, b);
        const auto by_tree = tree_pairs([](const auto&... x) { for_pairs(x...); }, a, b);
        const auto by_force = tree_pairs([](const auto&... x) { for_pairs_brute_force(x...); }, a, b);
        ASSERT_EQ(by_tree, by_force) << volume_a << ' ' << volume_b << ' ' << i;
        found += by_tree.size();
      }
    }
  }
  EXPECT_GT(found, 10000u);
}

// Law: within one tree every pair of different leaves that overlap is found once.
TEST(BoundingTree, FindsPairsOfItsOwnLeaves) {
  Dice dice("one cloud");
  Cloud cloud(dice, 21);
  for (const auto volume : volume_names()) {
    AnyTree any = cloud.tree(volume);
    for (int i = 0; i < 100; ++i) {
      cloud.move(dice, 0.5);
      std::visit(
          [&](auto& tree) {
            tree.refit(cloud.r, cloud.R);
            PairsFound by_tree, by_force;
            for_self_pairs(tree, [&](int a, int b) { return by_tree.emplace(a, b).second; });
            for_pairs_brute_force(tree, tree, [&](int a, int b) { return a >= b || by_force.emplace(a, b).second; });
            ASSERT_EQ(by_tree, by_force) << volume;
          },
          any);
    }
  }
}

// Law: after a motion every node holds all surfaces below it.
TEST(BoundingTree, NodesHoldTheirShapes) {
  Dice dice("nodes");
  Cloud cloud(dice, 7);
  for (const auto volume : volume_names()) {
    AnyTree any = cloud.tree(volume);
    std::visit(
        [&](auto& tree) {
          tree.refit(cloud.r, cloud.R);
          double worst = -1;
          for (int node = 0; node < tree.nodes(); ++node) {
            std::vector<int> below{node};
            for (std::size_t k = 0; k < below.size(); ++k) {
              if (!tree.is_leaf(below[k])) {
                const auto& children = tree.children(below[k]);
                below.insert(below.end(), children.begin(), children.end());
                continue;
              }
              const int leaf = tree.leaf_of(below[k]);
              const TreePart& part = cloud.parts[static_cast<std::size_t>(leaf)];
              for (const Vec3d& p : fixtures::surface_samples(*part.shape)) {
                const Vec3d in_object = part.at.position + part.at.orientation * p;
                worst =
                    std::fmax(worst, fixtures::outside(tree.volume(node), cloud.r[leaf] + cloud.R[leaf] * in_object));
              }
            }
          }
          EXPECT_LT(worst, 1e-12) << volume;
        },
        any);
  }
}

TEST(BoundingTree, StopsWhenTheVisitorHasEnough) {
  Dice dice("stop");
  Cloud cloud(dice, 20);
  BoundingTree<BoundingSphere> tree = std::get<0>(cloud.tree("sphere"));
  cloud.move(dice, 0.01);
  tree.refit(cloud.r, cloud.R);
  int calls = 0;
  const auto twice = [&](int, int) { return ++calls < 2; };
  EXPECT_LT(for_pairs(tree, tree, twice), 20);
  EXPECT_EQ(calls, 2);
  calls = 0;
  for_self_pairs(tree, twice);
  EXPECT_EQ(calls, 2);
}

// Count: far apart, one test of the two roots; a tree without leaves, none.
TEST(BoundingTree, CountsTests) {
  Dice dice("count");
  Cloud cloud(dice, 20);
  BoundingTree<BoundingSphere> here = std::get<0>(cloud.tree("sphere")), there = here;
  here.refit(cloud.r, cloud.R);
  for (Vec3d& r : cloud.r) r.x += 10;
  there.refit(cloud.r, cloud.R);
  const auto never = [](int, int) {
    ADD_FAILURE() << "they are apart";
    return true;
  };
  EXPECT_EQ(for_pairs(here, there, never), 1);
  EXPECT_EQ(for_pairs(here, BoundingTree<Obb>{}, never), 0);
  EXPECT_EQ(for_pairs_brute_force(here, there, never), 400);
}

TEST(BoundingTree, UnknownVolumeNamesTheNearest) {
  EXPECT_TRUE(fixtures::says(fixtures::error_of([] { (void)make_tree("spere", {}, {}); }),
                             {"bounding volume", "'spere'", "'sphere'"}));
}

// Rule: n leaves, n - 1 inner nodes, parents first, every node but the root the child of one.
TEST(TreeLayout, IsABinaryTree) {
  Dice dice("layout");
  for (int n = 1; n < 40; ++n) {
    std::vector<BoundingSphere> leaves;
    for (int i = 0; i < n; ++i) leaves.push_back({dice.vector(1), 0.1});
    const TreeLayout layout = split_top_down(leaves);
    EXPECT_EQ(layout.leaves, n);
    ASSERT_EQ(layout.children.size(), static_cast<std::size_t>(n - 1));
    std::vector<int> parents(static_cast<std::size_t>(2 * n - 1));
    for (int i = 0; i < n - 1; ++i) {
      for (const int child : layout.children[static_cast<std::size_t>(i)]) {
        EXPECT_GT(child, i);
        ++parents[static_cast<std::size_t>(child)];
      }
    }
    EXPECT_EQ(std::count(parents.begin(), parents.end(), 1), 2 * n - 2);
    EXPECT_LE(layout.depth(), std::ceil(std::log2(n)) + 1e-9);
  }
  EXPECT_EQ(split_top_down({}).leaves, 0);
}

}  // namespace
}  // namespace murosimf::geometry
