/// bounding_tree.h - a binary tree of bounding volumes about shapes that move with the objects of one entity.
///
/// The tree is laid out once; after a motion only its volumes are worked out again (paper 5.1).
#pragma once

#include <array>
#include <cassert>
#include <span>
#include <utility>
#include <vector>

#include "murosimf/geometry/tree_layout.h"
#include "murosimf/geometry/volume.h"

namespace murosimf::geometry {

template <class V>
class BoundingTree {
 public:
  struct Leaf {
    int object = 0;  ///< moves with this object
    V local;         ///< in the object's frame
  };

  BoundingTree() = default;
  /// `leaves` in the order of `layout`, at most TreeLayout::most_depth deep.
  BoundingTree(std::vector<Leaf> leaves, TreeLayout layout)
      : leaves_(std::move(leaves)), children_(std::move(layout.children)), volumes_(leaves_.size() + children_.size()) {
    assert(leaves_.size() == static_cast<std::size_t>(layout.leaves));
    assert(leaves_.empty() || children_.size() + 1 == leaves_.size());
  }

  /// Moves all volumes; r [m], R: poses of the entity's objects, world frame.
  void refit(std::span<const Vec3d> r, std::span<const Mat3d> R) noexcept {
    const std::size_t inner = children_.size();
    for (std::size_t i = 0; i < leaves_.size(); ++i) {
      const Leaf& leaf = leaves_[i];
      volumes_[inner + i] = moved(leaf.local, r[leaf.object], R[leaf.object]);
    }
    for (std::size_t i = inner; i-- > 0;) volumes_[i] = merged(volumes_[children_[i][0]], volumes_[children_[i][1]]);
  }

  [[nodiscard]] bool empty() const { return leaves_.empty(); }
  [[nodiscard]] int nodes() const { return static_cast<int>(volumes_.size()); }
  [[nodiscard]] const std::vector<Leaf>& leaves() const { return leaves_; }

  /// Of a node; node 0 is the root.
  [[nodiscard]] const V& volume(int node) const { return volumes_[node]; }
  [[nodiscard]] const std::array<int, 2>& children(int node) const { return children_[node]; }
  [[nodiscard]] bool is_leaf(int node) const { return node >= static_cast<int>(children_.size()); }
  /// Which leaf a node is that is_leaf.
  [[nodiscard]] int leaf_of(int node) const { return node - static_cast<int>(children_.size()); }
  [[nodiscard]] const V& leaf_volume(int leaf) const { return volumes_[children_.size() + leaf]; }

 private:
  std::vector<Leaf> leaves_;
  std::vector<std::array<int, 2>> children_;
  std::vector<V> volumes_;
};

extern template class BoundingTree<BoundingSphere>;
extern template class BoundingTree<Aabb>;
extern template class BoundingTree<Obb>;
extern template class BoundingTree<BoundingCapsule>;

}  // namespace murosimf::geometry
