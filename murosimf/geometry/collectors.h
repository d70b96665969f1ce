/// collectors.h - what to keep of the pairs that a traversal finds, after the exact test: the first, all, the deepest.
///
///     DeepestHit deepest([&](int a, int b, Manifold& found) { return collide(..., found); });
///     for_pairs(tree_a, tree_b, deepest);
///     if (deepest.hit) ...
#pragma once

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "murosimf/geometry/manifold.h"

namespace murosimf::geometry {

/// Two leaves that really overlap.
struct Hit {
  int a = 0, b = 0;
  Manifold manifold;
};

/// Depth [m] of the deepest point.
[[nodiscard]] inline double depth_of(const Manifold& manifold) {
  double deepest = 0;
  for (int i = 0; i < manifold.count; ++i) deepest = std::max(deepest, manifold.points[i].depth);
  return deepest;
}

/// Do any two overlap? `Exact` is called with two leaves and the manifold to fill; false if they do not overlap.
template <class Exact>
class FirstHit {
 public:
  explicit FirstHit(Exact exact) : exact_(std::move(exact)) {}
  bool operator()(int a, int b) {
    Hit found{a, b, {}};
    if (exact_(a, b, found.manifold)) hit = found;
    return !hit.has_value();
  }
  std::optional<Hit> hit;

 private:
  Exact exact_;
};

template <class Exact>
class AllHits {
 public:
  explicit AllHits(Exact exact) : exact_(std::move(exact)) {}
  bool operator()(int a, int b) {
    hits.push_back({a, b, {}});
    if (!exact_(a, b, hits.back().manifold)) hits.pop_back();
    return true;
  }
  std::vector<Hit> hits;  ///< to be cleared before it is used again

 private:
  Exact exact_;
};

template <class Exact>
class DeepestHit {
 public:
  explicit DeepestHit(Exact exact) : exact_(std::move(exact)) {}
  bool operator()(int a, int b) {
    Hit found{a, b, {}};
    if (exact_(a, b, found.manifold) && (!hit || depth_of(found.manifold) > depth_of(hit->manifold))) hit = found;
    return true;
  }
  std::optional<Hit> hit;

 private:
  Exact exact_;
};

}  // namespace murosimf::geometry
