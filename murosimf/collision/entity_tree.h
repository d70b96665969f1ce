/// entity_tree.h - broad phase of questions: the spheres of reach of all entities in one tree.
#pragma once

#include <algorithm>
#include <span>
#include <variant>
#include <vector>

#include "murosimf/geometry/bounding_tree.h"
#include "murosimf/geometry/traversal.h"

namespace murosimf::collision {

class EntityTree {
 public:
  /// `reach`: around each entity, world frame. `always`: by entity, true if it is to be found by every question; so is
  /// one whose sphere is infinite or not a number.
  void build(std::span<const geometry::BoundingSphere> reach, const std::vector<bool>& always);

  /// Entities, rising: at least those of which wanted(sphere of reach) holds, as it must then of every sphere that
  /// holds this one.
  template <class Wanted>
  void find(const Wanted& wanted, std::vector<int>& found) const {
    found = always_;
    geometry::for_leaves(tree_, wanted, [&](int leaf) {
      found.push_back(entities_[leaf]);
      return true;
    });
    std::sort(found.begin(), found.end());
  }

 private:
  geometry::BoundingTree<geometry::BoundingSphere> tree_;
  std::vector<int> entities_;  // by leaf
  std::vector<int> always_;
};

}  // namespace murosimf::collision
