#include "murosimf/geometry/triangle_mesh.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace murosimf::geometry {
namespace {

auto key(const Vec3d& v) { return std::tie(v.x, v.y, v.z); }

/// The first vertex of the list at the place of each vertex.
std::vector<std::uint32_t> first_at_place(const std::vector<Vec3d>& vertices) {
  std::vector<std::uint32_t> order(vertices.size()), first(vertices.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
    return key(vertices[a]) < key(vertices[b]) || (key(vertices[a]) == key(vertices[b]) && a < b);
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && key(vertices[order[i]]) == key(vertices[order[i - 1]]);
    first[order[i]] = same ? first[order[i - 1]] : order[i];
  }
  return first;
}

/// An edge from its lower to its higher vertex, and whether a triangle runs through it that way.
struct Edge {
  std::uint32_t low, high;
  int way;  ///< +1 or -1
};

std::vector<Edge> sorted_edges(const TriangleMesh& mesh) {
  std::vector<Edge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (const auto& corners : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = corners[i], to = corners[(i + 1) % 3];
      if (from != to) edges.push_back({std::min(from, to), std::max(from, to), from < to ? 1 : -1});
    }
  }
  std::ranges::sort(edges, {}, [](const Edge& e) { return std::tuple(e.low, e.high, e.way); });
  return edges;
}

}  // namespace

void merge_vertices(TriangleMesh& mesh) {
  const auto first = first_at_place(mesh.vertices);
  const auto none = static_cast<std::uint32_t>(mesh.vertices.size());
  std::vector<std::uint32_t> number(mesh.vertices.size(), none);
  std::vector<Vec3d> kept;
  for (auto& corners : mesh.triangles) {
    for (std::uint32_t& corner : corners) {
      std::uint32_t& mine = number[first[corner]];
      if (mine == none) {
        mine = static_cast<std::uint32_t>(kept.size());
        kept.push_back(mesh.vertices[corner]);
      }
      corner = mine;
    }
  }
  mesh.vertices = std::move(kept);
}

Seams find_seams(const TriangleMesh& mesh) {
  const auto edges = sorted_edges(mesh);
  Seams seams;
  for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
    int balance = 0;
    while (end < edges.size() && edges[end].low == edges[begin].low && edges[end].high == edges[begin].high) {
      balance += edges[end++].way;
    }
    if ((end - begin) % 2 == 1) {
      ++seams.open;
    } else if (balance != 0) {
      ++seams.flipped;
    }
  }
  return seams;
}

}  // namespace murosimf::geometry
