/// traversal.h - all pairs of leaves, of two trees or of one, whose volumes overlap.
///
/// Always descends into the bigger of the two volumes (paper 5.2). The order of pairs depends on the trees alone.
#pragma once

#include <array>
#include <utility>

#include "murosimf/geometry/bounding_tree.h"
#include "murosimf/geometry/volume_overlap.h"

namespace murosimf::geometry {

namespace detail {

/// Pairs of nodes that are still to be looked at.
class PairStack {
 public:
  [[nodiscard]] bool empty() const { return count_ == 0; }
  void push(int a, int b) { pairs_[count_++] = {a, b}; }
  /// Without a branch, which processors would mostly guess wrong.
  void push_if(bool wanted, int a, int b) {
    pairs_[count_] = {a, b};
    count_ += static_cast<std::size_t>(wanted);
  }
  std::array<int, 2> pop() { return pairs_[--count_]; }

 private:
  std::array<std::array<int, 2>, 2 * TreeLayout::most_depth + 2> pairs_;  // one pair waits for each step down
  std::size_t count_ = 0;
};

/// Goes down from the pairs on the stack. False if `visit` wants no more.
template <class V, class W, class Visit>
bool descend(const BoundingTree<V>& a, const BoundingTree<W>& b, int i, int j, int& tests, const Visit& visit) {
  PairStack stack;  // of pairs that overlap
  ++tests;
  stack.push_if(overlap(a.volume(i), b.volume(j)), i, j);
  while (!stack.empty()) {
    const auto [node_a, node_b] = stack.pop();
    const V& volume_a = a.volume(node_a);
    const W& volume_b = b.volume(node_b);
    const bool end_a = a.is_leaf(node_a), end_b = b.is_leaf(node_b);
    if (end_a && end_b) {
      if (!visit(a.leaf_of(node_a), b.leaf_of(node_b))) return false;
      continue;
    }
    tests += 2;
    if (end_b || (!end_a && size(volume_a) >= size(volume_b))) {
      const auto [left, right] = a.children(node_a);
      stack.push_if(overlap(a.volume(right), volume_b), right, node_b);
      stack.push_if(overlap(a.volume(left), volume_b), left, node_b);
    } else {
      const auto [left, right] = b.children(node_b);
      stack.push_if(overlap(volume_a, b.volume(right)), node_a, right);
      stack.push_if(overlap(volume_a, b.volume(left)), node_a, left);
    }
  }
  return true;
}

}  // namespace detail

/// Calls visit(leaf of a, leaf of b) for each pair of leaves whose volumes overlap, until it returns false. Returns the
/// number of pairs of volumes that were tested.
template <class V, class W, class Visit>
int for_pairs(const BoundingTree<V>& a, const BoundingTree<W>& b, const Visit& visit) {
  int tests = 0;
  if (!a.empty() && !b.empty()) detail::descend(a, b, 0, 0, tests, visit);
  return tests;
}

/// The same for two different leaves of one tree: each pair once, the smaller number first.
template <class V, class Visit>
int for_self_pairs(const BoundingTree<V>& tree, const Visit& visit) {
  int tests = 0;
  const auto sorted = [&](int i, int j) { return i < j ? visit(i, j) : visit(j, i); };
  for (int node = 0; !tree.is_leaf(node); ++node) {
    const auto& [left, right] = tree.children(node);
    if (!detail::descend(tree, tree, left, right, tests, sorted)) break;
  }
  return tests;
}

/// Calls visit(leaf) for each leaf whose volume overlaps `volume`, until it returns false. Returns the number of tests.
template <class V, class W, class Visit>
int for_volume(const BoundingTree<V>& tree, const W& volume, const Visit& visit) {
  if (tree.empty()) return 0;
  std::array<int, TreeLayout::most_depth + 1> stack{0};
  std::size_t count = 1;
  int tests = 0;
  while (count > 0) {
    const int node = stack[--count];
    ++tests;
    if (!overlap(tree.volume(node), volume)) continue;
    if (tree.is_leaf(node)) {
      if (!visit(tree.leaf_of(node))) break;
    } else {
      const auto& children = tree.children(node);
      stack[count++] = children[1];
      stack[count++] = children[0];
    }
  }
  return tests;
}

/// What for_pairs finds, by testing all leaves.
template <class V, class W, class Visit>
int for_pairs_brute_force(const BoundingTree<V>& a, const BoundingTree<W>& b, const Visit& visit) {
  int tests = 0;
  for (int i = 0; i < static_cast<int>(a.leaves().size()); ++i) {
    for (int j = 0; j < static_cast<int>(b.leaves().size()); ++j) {
      ++tests;
      if (overlap(a.leaf_volume(i), b.leaf_volume(j)) && !visit(i, j)) return tests;
    }
  }
  return tests;
}

}  // namespace murosimf::geometry
