#include "murosimf/collision/relief/inner_depth.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "murosimf/geometry/bounding_tree.h"
#include "murosimf/geometry/ray.h"
#include "murosimf/geometry/traversal.h"
#include "murosimf/geometry/volume_overlap.h"
#include "murosimf/math/assert.h"

namespace murosimf::collision {
namespace {

using geometry::Aabb;
using geometry::Ray;

constexpr double thinnest = 1e-4;  // [m] a solid it must be

Aabb box_of(const ReliefTriangle& triangle) {
  Vec3d low = triangle.corners[0], high = low;
  for (const Vec3d& p : triangle.corners) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return {0.5 * (low + high), 0.5 * (high - low)};
}

/// [m] Along the ray to the triangle, from either side; infinite if it misses it.
double way_to(const ReliefTriangle& triangle, const Ray& ray) {
  constexpr double never = std::numeric_limits<double>::infinity();
  const double approach = dot(ray.direction, triangle.normal);
  if (std::abs(approach) < 1e-9) return never;
  const double way = dot(triangle.corners[0] - ray.origin, triangle.normal) / approach;
  if (!(way > 0)) return never;
  const Vec3d p = ray.origin + way * ray.direction;
  for (std::size_t k = 0; k < 3; ++k) {
    if (dot(p - triangle.corners[k], triangle.edges[k].outward) > 0) return never;
  }
  return way;
}

geometry::BoundingTree<Aabb> tree_of(std::span<const ReliefTriangle> triangles) {
  std::vector<geometry::BoundingTree<Aabb>::Leaf> leaves;
  std::vector<geometry::BoundingSphere> spheres;
  for (const ReliefTriangle& triangle : triangles) {
    const Aabb box = box_of(triangle);
    leaves.push_back({0, box});
    spheres.push_back(geometry::sphere_around(box));
  }
  geometry::BoundingTree<Aabb> tree(std::move(leaves), geometry::split_top_down(spheres));
  const Vec3d origin;
  const Mat3d upright;
  tree.refit({&origin, 1}, {&upright, 1});
  return tree;
}

}  // namespace

std::vector<InnerDepth> inner_depths(std::span<const ReliefTriangle> triangles, double most) {
  constexpr double to_corner = 0.95;  // [1] of the way there from the middle
  MUROSIMF_ASSERT(most > 0);
  const auto tree = tree_of(triangles);
  std::vector<InnerDepth> depths;
  depths.reserve(triangles.size());
  for (const ReliefTriangle& triangle : triangles) {
    const auto depth_from = [&](const Vec3d& p) {
      const Ray inwards{p, -triangle.normal};
      double way = 2 * most;
      const auto wanted = [&](const Aabb& box) { return geometry::ray_enters(box, inwards, way); };
      const auto visit = [&](int i) {
        if (&triangles[i] != &triangle) way = std::min(way, way_to(triangles[i], inwards));
        return true;
      };
      (void)geometry::for_leaves(tree, wanted, visit);
      return std::max(thinnest, 0.5 * way);
    };
    const auto& [a, b, c] = triangle.corners;
    const Vec3d middle = (1.0 / 3) * (a + b + c);
    InnerDepth& depth = depths.emplace_back();
    depth.middle = depth.least = depth_from(middle);
    for (const Vec3d& corner : triangle.corners) {
      depth.least = std::min(depth.least, depth_from(middle + to_corner * (corner - middle)));
    }
  }
  MUROSIMF_ASSERT(depths.size() == triangles.size());
  return depths;
}

}  // namespace murosimf::collision
