#include "murosimf/geometry/vertex_clusters.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace murosimf::geometry {
namespace {

constexpr double most_cells = 1 << 20;  // along an axis: three numbers of a cell fit into one

struct Bounds {
  explicit Bounds(const std::vector<Vec3d>& points) {
    for (const Vec3d& p : points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
  }
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  Vec3d low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};
};

/// Number of the cell of each vertex.
std::vector<std::uint64_t> cells_of(const std::vector<Vec3d>& vertices, const Bounds& bounds, double cell) {
  const Vec3d size = bounds.high - bounds.low;
  const double edge = std::max(cell, std::max({size.x, size.y, size.z}) / most_cells);
  const auto along = [&](double distance) { return static_cast<std::uint64_t>(std::floor(distance / edge)); };
  std::vector<std::uint64_t> cells;
  cells.reserve(vertices.size());
  for (const Vec3d& v : vertices) {
    const Vec3d p = v - bounds.low;
    cells.push_back(along(p.x) << 42U | along(p.y) << 21U | along(p.z));
  }
  return cells;
}

/// The vertex that stays of each vertex's cell.
std::vector<std::uint32_t> survivors(const std::vector<Vec3d>& vertices, double cell) {
  const Bounds bounds(vertices);
  const auto cells = cells_of(vertices, bounds, cell);
  const Vec3d middle = 0.5 * (bounds.low + bounds.high);
  const auto reach = [&](std::uint32_t i) { return dot(vertices[i] - middle, vertices[i] - middle); };
  std::vector<std::uint32_t> order(vertices.size()), survivor(vertices.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, {}, [&](std::uint32_t i) { return cells[i]; });
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    std::uint32_t best = order[begin];
    for (; end < order.size() && cells[order[end]] == cells[order[begin]]; ++end) {
      if (reach(order[end]) > reach(best)) best = order[end];
    }
    for (std::size_t i = begin; i < end; ++i) survivor[order[i]] = best;
  }
  return survivor;
}

/// With the lowest corner first, so that equal triangles look equal.
std::array<std::uint32_t, 3> turned(std::array<std::uint32_t, 3> corners) {
  std::ranges::rotate(corners, std::ranges::min_element(corners));
  return corners;
}

}  // namespace

TriangleMesh cluster_vertices(const TriangleMesh& mesh, double cell) {
  const auto survivor = survivors(mesh.vertices, cell);
  TriangleMesh coarse{mesh.vertices, {}};
  for (const auto& [i, j, k] : mesh.triangles) {
    const std::uint32_t a = survivor[i], b = survivor[j], c = survivor[k];
    if (a != b && b != c && c != a) coarse.triangles.push_back(turned({a, b, c}));
  }
  std::ranges::sort(coarse.triangles);
  coarse.triangles.erase(std::ranges::unique(coarse.triangles).begin(), coarse.triangles.end());
  merge_vertices(coarse);
  return coarse;
}

}  // namespace murosimf::geometry
