/// bounding_tree.h - a binary tree of bounding volumes about shapes that move with the objects of one entity.
///
/// The tree is laid out once, and copies share that; after a motion only its volumes are worked out again (paper 5.1). With a
/// margin they are that much bigger than they need be, and still right after small motions.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "murosimf/geometry/tree_layout.h"
#include "murosimf/geometry/volume.h"
#include "murosimf/math/assert.h"

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
      : parts_(std::make_shared<const Parts>(Parts{std::move(leaves), std::move(layout.children)})),
        volumes_(parts_->leaves.size() + parts_->children.size()),
        margin_(margin),
        fitted_(margin > 0 ? parts_->leaves.size() : 0) {
    MUROSIMF_ASSERT(parts_->leaves.size() == static_cast<std::size_t>(layout.leaves));
    MUROSIMF_ASSERT(parts_->leaves.empty() || parts_->children.size() + 1 == parts_->leaves.size());
  }

  /// Moves all volumes; r [m], R: poses of the entity's objects, world frame.
  void refit(std::span<const Vec3d> r, std::span<const Mat3d> R) noexcept {
    const auto& [leaves, children] = *parts_;
    const std::size_t inner = children.size();
    for (std::size_t i = 0; i < leaves.size(); ++i) {
      const Leaf& leaf = leaves[i];
      volumes_[inner + i] = grown(moved(leaf.local, r[leaf.object], R[leaf.object]), margin_);
      if (margin_ > 0) fitted_[i] = {r[leaf.object], R[leaf.object]};
    }
    for (std::size_t i = inner; i-- > 0;) volumes_[i] = merged(volumes_[children[i][0]], volumes_[children[i][1]]);
  }

  /// True if nothing that the leaves enclosed has moved by more than the margin since they were fitted: the tree still
  /// encloses it. A turn by dR moves what is within rho of a center by less than |dR| rho (Frobenius norm); of a sphere
  /// only its center counts.
  [[nodiscard]] bool still_fits(std::span<const Vec3d> r, std::span<const Mat3d> R) const noexcept {
    if (margin_ <= 0) return empty();
    for (std::size_t i = 0; i < leaves().size(); ++i) {
      const Leaf& leaf = leaves()[i];
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

  [[nodiscard]] bool empty() const { return volumes_.empty(); }
  [[nodiscard]] int nodes() const { return static_cast<int>(volumes_.size()); }
  [[nodiscard]] const std::vector<Leaf>& leaves() const { return parts_->leaves; }

  /// Of a node; node 0 is the root.
  [[nodiscard]] const V& volume(int node) const { return volumes_[node]; }
  [[nodiscard]] const std::array<int, 2>& children(int node) const { return parts_->children[node]; }
  [[nodiscard]] bool is_leaf(int node) const { return node >= inner_nodes(); }
  /// Which leaf a node is that is_leaf.
  [[nodiscard]] int leaf_of(int node) const { return node - inner_nodes(); }
  [[nodiscard]] const V& leaf_volume(int leaf) const { return volumes_[inner_nodes() + leaf]; }

 private:
  struct Parts {
    std::vector<Leaf> leaves;
    std::vector<std::array<int, 2>> children;  // of the inner nodes
  };
  /// There are n leaves and n - 1 inner nodes, or none of either.
  [[nodiscard]] int inner_nodes() const { return nodes() / 2; }

  std::shared_ptr<const Parts> parts_ = std::make_shared<const Parts>();
  std::vector<V> volumes_;
  double margin_ = 0;               // [m]
  std::vector<Transformd> fitted_;  // of each leaf's object, when it was fitted
};

extern template class BoundingTree<BoundingSphere>;
extern template class BoundingTree<Aabb>;
extern template class BoundingTree<Obb>;
extern template class BoundingTree<BoundingCapsule>;

}  // namespace murosimf::geometry
