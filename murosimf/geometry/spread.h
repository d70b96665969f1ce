/// spread.h - a few of many points: those that carry best.
#pragma once

#include <algorithm>
#include <array>
#include <limits>

#include "murosimf/geometry/manifold.h"
#include "murosimf/math/insertion_sort.h"

namespace murosimf::geometry {

/// Indices of the points that were chosen, rising.
struct Chosen {
  int count = 0;
  std::array<int, Manifold::most_points> index;
};

namespace detail {

constexpr double clearly_farther = 1.1;  // else the first one: regular polygons are full of ties
/// Limits below which a deeper point does not count: of its depth, and of the width of all points.
constexpr double clearly_deeper = 0.05, clearly_leaning = 1e-3;

/// The point of positive depth that is farthest from all chosen ones; -1 if none is left.
template <class PointAt, class DepthAt>
int farthest(int count, const PointAt& point, const DepthAt& depth, const Chosen& chosen) {
  int best = -1;
  double best_square = 0;
  for (int i = 0; i < count; ++i) {
    if (!(depth(i) > 0)) continue;
    double square = std::numeric_limits<double>::infinity();
    for (int k = 0; k < chosen.count; ++k) {
      const Vec3d way = point(i) - point(chosen.index[k]);
      square = std::min(square, dot(way, way));
    }
    if (square > clearly_farther * best_square) {
      best_square = square;
      best = i;
    }
  }
  return best;
}

}  // namespace detail

/// Up to eight of the points 0 .. count-1 whose depth is positive: all, if there are no more; else one, the farthest from
/// it, the farthest from both, and so on; and the deepest, unless one of these is about as deep. It begins with the first
/// and not with the deepest: on a flat side, where all are about equally deep, the choice must not depend on how the body
/// rocks.
template <class PointAt, class DepthAt>
Chosen choose_spread(int count, const PointAt& point, const DepthAt& depth) {
  Chosen chosen;
  int below = 0, deepest = -1;
  for (int i = 0; i < count; ++i) {
    if (!(depth(i) > 0)) continue;
    if (below < Manifold::most_points) chosen.index[below] = i;
    ++below;
    if (deepest < 0 || depth(i) > depth(deepest)) deepest = i;
  }
  chosen.count = std::min(below, Manifold::most_points);
  if (below <= Manifold::most_points) return chosen;
  for (chosen.count = 1; chosen.count < Manifold::most_points; ++chosen.count) {
    const int next = detail::farthest(count, point, depth, chosen);
    if (next < 0) break;  // the rest coincides with those chosen
    chosen.index[chosen.count] = next;
  }
  const auto end = chosen.index.begin() + chosen.count;
  const auto shallower = [&](int i, int k) { return depth(i) < depth(k); };
  const int deepest_chosen = *std::max_element(chosen.index.begin(), end, shallower);
  const double width = norm(point(chosen.index[std::min(1, chosen.count - 1)]) - point(chosen.index[0]));
  const double missing = depth(deepest) - depth(deepest_chosen);
  if (missing > std::min(detail::clearly_deeper * depth(deepest), detail::clearly_leaning * width))
    chosen.index[chosen.count - 1] = deepest;
  insertion_sort(chosen.index.begin(), end);
  return chosen;
}

}  // namespace murosimf::geometry
