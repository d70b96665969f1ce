/// bounding_tree.h - a binary tree of bounding volumes about shapes that move with the objects of one entity.
///
/// The tree is laid out once; after a motion only its volumes are worked out again (paper 5.1). With a margin they are
/// that much bigger than they need be, and still right after small motions.
#pragma once

#include <array>
#include <cassert>
#include <span>
#include <type_traits>
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
  BoundingTree(std::vector<Leaf> leaves, TreeLayout layout, double margin = 0)
      : leaves_(std::move(leaves)),
        children_(std::move(layout.children)),
        volumes_(leaves_.size() + children_.size()),
        margin_(margin),
        fitted_(leaves_.size()) {
    assert(leaves_.size() == static_cast<std::size_t>(layout.leaves));
    assert(leaves_.empty() || children_.size() + 1 == leaves_.size());
  }

  /// Moves all volumes; r [m], R: poses of the entity's objects, world frame.
  void refit(std::span<const Vec3d> r, std::span<const Mat3d> R) noexcept {
    const std::size_t inner = children_.size();
    for (std::size_t i = 0; i < leaves_.size(); ++i) {
      const Leaf& leaf = leaves_[i];
      volumes_[inner + i] = grown(moved(leaf.local, r[leaf.object], R[leaf.object]), margin_);
      fitted_[i] = {r[leaf.object], R[leaf.object]};
    }
    for (std::size_t i = inner; i-- > 0;) volumes_[i] = merged(volumes_[children_[i][0]], volumes_[children_[i][1]]);
  }

  /// True if nothing that the leaves enclosed has moved by more than the margin since they were fitted: the tree still
  /// encloses it. A turn by dR moves what is within rho of a center by less than |dR| rho (Frobenius norm); of a sphere
  /// only its center counts.
  [[nodiscard]] bool still_fits(std::span<const Vec3d> r, std::span<const Mat3d> R) const noexcept {
    for (std::size_t i = 0; i < leaves_.size(); ++i) {
      const Leaf& leaf = leaves_[i];
      const BoundingSphere sphere = sphere_around(leaf.local);
      const Transformd& old = fitted_[i];
      const Mat3d turn{R[leaf.object].x - old.orientation.x, R[leaf.object].y - old.orientation.y,
                       R[leaf.object].z - old.orientation.z};
      const Vec3d way = r[leaf.object] - old.position + turn * sphere.center;
      double room = margin_;
      if constexpr (!std::is_same_v<V, BoundingSphere>) {
        room -= sphere.radius * sqrt(dot(turn.x, turn.x) + dot(turn.y, turn.y) + dot(turn.z, turn.z));
      }
      if (!(room > 0 && dot(way, way) < room * room)) return false;
    }
    return true;
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
  double margin_ = 0;               // [m]
  std::vector<Transformd> fitted_;  // of each leaf's object, when it was fitted
};

extern template class BoundingTree<BoundingSphere>;
extern template class BoundingTree<Aabb>;
extern template class BoundingTree<Obb>;
extern template class BoundingTree<BoundingCapsule>;

}  // namespace murosimf::geometry
