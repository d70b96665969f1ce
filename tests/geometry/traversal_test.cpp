#include "murosimf/geometry/traversal.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "murosimf/geometry/any_tree.h"
#include "murosimf/geometry/collectors.h"
#include "tests/geometry/volume_fixtures.h"

namespace murosimf::geometry {
namespace {

using fixtures::Dice;

/// Balls, one object each, in a tree of some kind of volume.
struct Balls {
  Balls(Dice& dice, std::string_view volume, int count, const Vec3d& middle) {
    std::vector<TreePart> parts;
    std::vector<BoundingSphere> spheres;
    for (int i = 0; i < count; ++i) {
      centers.push_back(middle + dice.vector(0.5));
      radii.push_back(dice.uniform(0.01, 0.15));
      shapes.emplace_back(Sphere{radii.back()});
      spheres.push_back({centers.back(), radii.back()});
    }
    for (int i = 0; i < count; ++i) parts.push_back({i, &shapes[static_cast<std::size_t>(i)], {}});
    tree = make_tree(volume, parts, split_top_down(spheres));
    const std::vector<Mat3d> R(centers.size(), dice.turn());
    std::visit([&](auto& any) { any.refit(centers, R); }, tree);
  }
  std::vector<Vec3d> centers;
  std::vector<double> radii;
  std::vector<Shape> shapes;
  AnyTree tree;
};

double distance(const Balls& a, const Balls& b, int i, int j) {
  return std::fmax(norm(a.centers[i] - b.centers[j]) - a.radii[i] - b.radii[j], 0);
}

/// Calls f(a, b) for two heaps of balls in trees of all 16 pairs of kinds.
template <class F>
void for_all_heaps(const F& f) {
  Dice dice("heaps");
  for (const auto volume_a : volume_names()) {
    for (const auto volume_b : volume_names()) {
      for (int i = 0; i < 40; ++i) {
        f(Balls(dice, volume_a, 15, {}), Balls(dice, volume_b, 22, {i % 2 ? 0.5 : 1.5, 0, 0}));
      }
    }
  }
}

// Law: the least of the distances of all pairs, for all kinds of volumes, and with fewer of them looked at.
TEST(Traversal, FindsTheNearestPair) {
  int calls = 0, all = 0;
  for_all_heaps([&](const Balls& a, const Balls& b) {
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 15; ++i) {
      for (int j = 0; j < 22; ++j) least = std::fmin(least, distance(a, b, i, j));
    }
    all += 15 * 22;
    const auto count = [&](int i, int j) {
      ++calls;
      return distance(a, b, i, j);
    };
    const auto search = [&](const auto& tree_a, const auto& tree_b) {
      const double none = std::numeric_limits<double>::infinity();
      EXPECT_EQ(nearest_pair(tree_a, tree_b, none, count), least);
      EXPECT_EQ(nearest_pair(tree_a, tree_b, 0.5 * least, count), 0.5 * least);
    };
    std::visit(search, a.tree, b.tree);
  });
  EXPECT_LT(calls, all / 10);
}

/// The overlap of two balls, as a manifold of one point.
auto balls_collide(const Balls& a, const Balls& b) {
  return [&a, &b](int i, int j, Manifold& found) {
    const Vec3d way = a.centers[i] - b.centers[j];
    const double depth = a.radii[i] + b.radii[j] - norm(way);
    if (!(depth > 0)) return false;
    found.count = 1;
    found.points[0].depth = depth;
    return true;
  };
}

// Law: collectors keep what a walk over all pairs keeps: all that overlap, the deepest of them, and one, if there is
// one.
TEST(Traversal, CollectorsKeepWhatTheyPromise) {
  int found = 0;
  for_all_heaps([&](const Balls& a, const Balls& b) {
    const auto exact = balls_collide(a, b);
    double deepest = 0;
    std::size_t count = 0;
    for (int i = 0; i < 15; ++i) {
      for (int j = 0; j < 22; ++j) {
        Manifold manifold;
        if (!exact(i, j, manifold)) continue;
        ++count;
        deepest = std::fmax(deepest, manifold.points[0].depth);
      }
    }
    found += static_cast<int>(count);
    FirstHit first(exact);
    AllHits all(exact);
    DeepestHit deep(exact);
    const auto meet = [&](const auto& tree_a, const auto& tree_b) {
      for_pairs(tree_a, tree_b, first);
      for_pairs(tree_a, tree_b, all);
      for_pairs(tree_a, tree_b, deep);
    };
    std::visit(meet, a.tree, b.tree);
    EXPECT_EQ(all.hits.size(), count);
    EXPECT_EQ(first.hit.has_value(), count > 0);
    ASSERT_EQ(deep.hit.has_value(), count > 0);
    EXPECT_EQ(deep.hit ? depth_of(deep.hit->manifold) : 0, deepest);
  });
  EXPECT_GT(found, 1000);
}

// Law: the leaves that a ray enters are those that testing all of them finds.
TEST(Traversal, FindsLeavesOnARay) {
  Dice dice("rays");
  int found = 0;
  for (const auto volume : volume_names()) {
    for (int i = 0; i < 100; ++i) {
      const Balls balls(dice, volume, 30, {});
      const Ray ray{dice.vector(1), dice.unit()};
      const auto wanted = [&](const auto& v) { return ray_enters(v, ray, 2); };
      std::vector<bool> by_tree(30), by_force(30);
      const auto visit = [&](int leaf) {
        EXPECT_FALSE(by_tree[leaf]);
        return by_tree[leaf] = true;
      };
      const auto compare = [&](const auto& tree) {
        EXPECT_LE(for_leaves(tree, wanted, visit), tree.nodes());
        for (int leaf = 0; leaf < 30; ++leaf) by_force[leaf] = wanted(tree.leaf_volume(leaf));
      };
      std::visit(compare, balls.tree);
      EXPECT_EQ(by_tree, by_force);
      found += static_cast<int>(std::count(by_tree.begin(), by_tree.end(), true));
    }
  }
  EXPECT_GT(found, 50);
}

}  // namespace
}  // namespace murosimf::geometry
