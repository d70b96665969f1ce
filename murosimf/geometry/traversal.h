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

/// Goes down from the pairs on the stack. False if `visit` has ended it.
template <class V, class W, class Visit>
bool descend(const BoundingTree<V>& a, const BoundingTree<W>& b, int i, int j, int& tests, Visit&& visit) {
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
int for_pairs(const BoundingTree<V>& a, const BoundingTree<W>& b, Visit&& visit) {
  int tests = 0;
  if (!a.empty() && !b.empty()) detail::descend(a, b, 0, 0, tests, visit);
  return tests;
}

/// The same for two different leaves of one tree: each pair once, the smaller number first.
template <class V, class Visit>
int for_self_pairs(const BoundingTree<V>& tree, Visit&& visit) {
  int tests = 0;
  const auto sorted = [&](int i, int j) { return i < j ? visit(i, j) : visit(j, i); };
  for (int node = 0; !tree.is_leaf(node); ++node) {
    const auto& [left, right] = tree.children(node);
    if (!detail::descend(tree, tree, left, right, tests, sorted)) break;
  }
  return tests;
}

/// Calls visit(leaf) for each leaf of which wanted(volume) holds, as it must then of all volumes around it, until it
/// returns false. Both may change what is wanted. Returns the number of volumes that were tested.
template <class V, class Wanted, class Visit>
int for_leaves(const BoundingTree<V>& tree, Wanted&& wanted, Visit&& visit) {
  if (tree.empty()) return 0;
  std::array<int, TreeLayout::most_depth + 1> stack;  // one node waits for each step down
  std::size_t count = 0;
  int tests = 0;
  stack[count++] = 0;
  while (count > 0) {
    const int node = stack[--count];
    ++tests;
    if (!wanted(tree.volume(node))) continue;
    if (tree.is_leaf(node)) {
      if (!visit(tree.leaf_of(node))) break;
      continue;
    }
    stack[count++] = tree.children(node)[1];
    stack[count++] = tree.children(node)[0];
  }
  return tests;
}

/// Calls distance(leaf of a, leaf of b) for pairs of leaves that may be nearer than all before; it returns their
/// distance [m]. `best` [m]: only what is nearer counts. Returns the least distance, or `best` if there is none less.
template <class V, class W, class Distance>
double nearest_pair(const BoundingTree<V>& a, const BoundingTree<W>& b, double best, Distance&& distance) {
  if (a.empty() || b.empty()) return best;
  detail::PairStack stack;
  stack.push(0, 0);
  const auto apart = [&](int i, int j) { return gap(a.volume(i), b.volume(j)); };
  const auto push_nearer_last = [&](std::array<int, 2> one, std::array<int, 2> other) {
    if (apart(one[0], one[1]) < apart(other[0], other[1])) std::swap(one, other);
    stack.push(one[0], one[1]);
    stack.push(other[0], other[1]);
  };
  while (!stack.empty()) {
    const auto [i, j] = stack.pop();
    if (!(apart(i, j) < best)) continue;
    const bool end_a = a.is_leaf(i), end_b = b.is_leaf(j);
    if (end_a && end_b) {
      best = std::min(best, distance(a.leaf_of(i), b.leaf_of(j)));
    } else if (end_b || (!end_a && size(a.volume(i)) >= size(b.volume(j)))) {
      push_nearer_last({a.children(i)[0], j}, {a.children(i)[1], j});
    } else {
      push_nearer_last({i, b.children(j)[0]}, {i, b.children(j)[1]});
    }
  }
  return best;
}

/// What for_pairs finds, by testing all leaves.
template <class V, class W, class Visit>
int for_pairs_brute_force(const BoundingTree<V>& a, const BoundingTree<W>& b, Visit&& visit) {
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
