// Which entities a question comes near: never fewer than a walk over all finds, rising, and few more.
#include "murosimf/collision/entity_tree.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "tests/fixtures.h"

namespace murosimf::collision {
namespace {

using fixtures::Dice;
using geometry::BoundingSphere;

// Law: rays and regions find all whose spheres they meet, in rising order; infinite ones and those that are to be found
// by all come with them, and those by none never do.
TEST(EntityTree, FindsAllThatAreMet) {
  Dice dice("entities");
  EntityTree tree;
  std::size_t met = 0, found_in_all = 0, all = 0;
  for (int i = 0; i < 2000; ++i) {
    std::vector<BoundingSphere> reach;
    const int count = dice.pick(40);
    std::vector<FoundBy> found_by(static_cast<std::size_t>(count), FoundBy::those_near);
    for (int k = 0; k < count; ++k) reach.push_back({dice.vector(4), dice.uniform(0, 0.6)});
    if (count > 5) {
      found_by[1] = FoundBy::none;
      found_by[2] = FoundBy::all;
      reach[3].radius = std::numeric_limits<double>::infinity();
      reach[4].center.z = std::nan("");
    }
    tree.build(reach, found_by);
    const geometry::Ray ray{dice.vector(3), dice.unit()};
    const double range = dice.uniform(0, 6);
    const auto wanted = [&](const BoundingSphere& sphere) {
      return i % 2 ? ray_enters(sphere, ray, range) : overlap(BoundingSphere{ray.origin, 0.3 * range}, sphere);
    };
    std::vector<int> found;
    tree.find(wanted, found);
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
    EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end()) << "each once";
    for (int k = 0; k < count; ++k) {
      if (found_by[k] == FoundBy::none) {
        EXPECT_FALSE(std::binary_search(found.begin(), found.end(), k)) << i << " " << k;
        continue;
      }
      if (!wanted(reach[k]) && found_by[k] != FoundBy::all) continue;
      ++met;
      EXPECT_TRUE(std::binary_search(found.begin(), found.end(), k)) << i << " " << k;
    }
    found_in_all += found.size();
    all += static_cast<std::size_t>(count);
  }
  EXPECT_GT(met, 3000U);
  EXPECT_LT(found_in_all, met + 2 * 2000) << "but for two that are in no tree";
  EXPECT_LT(2 * met, all);
}

TEST(EntityTree, NobodyIsFoundInAnEmptyWorld) {
  EntityTree tree;
  std::vector<int> found{7};
  tree.build({}, {});
  tree.find([](const BoundingSphere&) { return true; }, found);
  EXPECT_TRUE(found.empty());
}

}  // namespace
}  // namespace murosimf::collision
