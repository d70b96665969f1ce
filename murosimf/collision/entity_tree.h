/// entity_tree.h - broad phase of questions: the spheres of reach of all entities in one tree.
#pragma once

#include <algorithm>
#include <span>
#include <variant>
#include <vector>

#include "murosimf/geometry/bounding_tree.h"
#include "murosimf/geometry/traversal.h"

namespace murosimf::collision {

/// Which questions find an entity.
enum class FoundBy {
  those_near,  ///< all, if its sphere of reach is infinite or not a number
  all,
  none,
};

class EntityTree {
 public:
  /// `reach`: around each entity, world frame. As many of either.
  void build(std::span<const geometry::BoundingSphere> reach, std::span<const FoundBy> found_by);

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
