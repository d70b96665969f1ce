/// deepest_points.h - one point for everything that touches: the deepest, as in the paper (5.3, "there is only one contact
/// point").
#pragma once

#include <algorithm>
#include <vector>

namespace murosimf::collision {

/// Keeps the deepest of those points that belong together, the first of equals; then sorts them by `before`.
template <class Point, class Together, class Before>
void keep_deepest(std::vector<Point>& points, Together together, Before before) {
  auto end = points.begin();  // of those that are kept
  for (const Point& point : points) {
    const auto best = std::find_if(points.begin(), end, [&](const Point& other) { return together(point, other); });
    if (best == end) {
      *end++ = point;
    } else if (point.depth > best->depth) {
      *best = point;
    }
  }
  points.erase(end, points.end());
  std::sort(points.begin(), points.end(), before);
}

}  // namespace murosimf::collision
