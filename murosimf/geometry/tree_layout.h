/// tree_layout.h - which leaves of a binary tree hang together, before volumes are put into it.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "murosimf/geometry/volume.h"

namespace murosimf::geometry {

/// n leaves and n - 1 inner nodes, numbered in one row: inner nodes first, the root before all, parents before their
/// children; then the leaves in their own order.
struct TreeLayout {
  /// Longest way from the root to a leaf that trees may have: traversals keep their stack in an array.
  static constexpr int most_depth = 64;

  int leaves = 0;
  std::vector<std::array<int, 2>> children;  ///< of each inner node

  [[nodiscard]] int depth() const;
};

/// Splits the leaves top-down where their centers lie farthest apart: at the median along the longest axis (paper 5.1,
/// unstructured compounds).
[[nodiscard]] TreeLayout split_top_down(std::span<const BoundingSphere> leaves);

/// Puts a tree together from its leaves.
class TreeBuilder {
 public:
  /// A part of the tree: its topmost node, and a sphere about its leaves.
  struct Part {
    int node = 0;
    BoundingSphere sphere;
  };

  explicit TreeBuilder(std::span<const BoundingSphere> leaves) : leaves_(leaves) {}

  [[nodiscard]] Part leaf(int i) const { return {i, leaves_[static_cast<std::size_t>(i)]}; }
  Part join(const Part& a, const Part& b);
  /// Joins the two whose common sphere is the smallest, until one is left.
  Part join_nearest(std::vector<Part> parts);
  /// A top-down tree of some of the leaves, at least one.
  Part split(std::vector<int> leaves);

  /// `root` holds all leaves.
  [[nodiscard]] TreeLayout layout(const Part& root) const;

 private:
  std::span<const BoundingSphere> leaves_;
  std::vector<std::array<int, 2>> joints_;  // node number: leaves, then these
};

}  // namespace murosimf::geometry
