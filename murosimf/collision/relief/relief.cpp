#include "murosimf/collision/relief/relief.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "murosimf/collision/relief/inner_depth.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::collision {
namespace {

constexpr double thin = 1e-4;  // [m] walls around a height field: the prisms beside them fill it
constexpr double flat = 1e-6;  // [1] sine of the angle below which neighbors are of one plane

Vec3d unit(const Vec3d& v) {
  const double size = norm(v);
  return size > 0 ? (1 / size) * v : Vec3d{};
}

bool is_finite(const Vec3d& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// False if the three corners lie in a line.
bool has_area(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const double longest = std::max({norm(b - a), norm(c - b), norm(a - c)});
  return norm(cross(b - a, c - a)) > 1e-9 * longest * longest;
}

}  // namespace

Relief::Relief(geometry::TriangleMesh mesh, const Options& options) : mesh_(std::move(mesh)), bottom_(options.bottom) {
  geometry::merge_vertices(mesh_);
  if (!std::ranges::all_of(mesh_.vertices, is_finite)) throw SetupError("a corner of the surface is not finite");
  find_triangles();
  if (triangles_.empty()) throw SetupError("the surface has no triangle with an area");
  find_neighbors();
  find_vertices();
  find_walls();
  find_depths(options.thickness);
}

void Relief::find_triangles() {
  std::erase_if(mesh_.triangles, [&](const auto& corners) {
    return !has_area(mesh_.vertices[corners[0]], mesh_.vertices[corners[1]], mesh_.vertices[corners[2]]);
  });
  for (const auto& corners : mesh_.triangles) {
    ReliefTriangle& triangle = triangles_.emplace_back();
    triangle.vertices = corners;
    for (std::size_t k = 0; k < 3; ++k) triangle.corners[k] = mesh_.vertices[corners[k]];
    const auto& [a, b, c] = triangle.corners;
    triangle.normal = unit(cross(b - a, c - a));
    for (std::size_t k = 0; k < 3; ++k) {
      ReliefEdge& edge = triangle.edges[k];
      edge.outward = unit(cross(triangle.corners[(k + 1) % 3] - triangle.corners[k], triangle.normal));
      edge.neighbor_outward = triangle.normal;
      edge.normal_limit = edge.outward;
      edge.stands_out = edge.is_own = true;
    }
  }
}

/// Two triangles are neighbors if they run through an edge in opposite directions, and no third one has it.
void Relief::find_neighbors() {
  struct Side {
    std::uint32_t low, high;
    int triangle, edge;
    bool rising;
  };
  std::vector<Side> sides;
  for (int i = 0; i < static_cast<int>(triangles_.size()); ++i) {
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t from = triangles_[i].vertices[k], to = triangles_[i].vertices[(k + 1) % 3];
      sides.push_back({std::min(from, to), std::max(from, to), i, k, from < to});
    }
  }
  const auto key = [](const Side& side) { return std::tuple(side.low, side.high, side.triangle); };
  std::ranges::sort(sides, {}, key);
  const auto same = [](const Side& a, const Side& b) { return a.low == b.low && a.high == b.high; };
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    while (end < sides.size() && same(sides[begin], sides[end])) ++end;
    if (end - begin != 2 || sides[begin].rising == sides[begin + 1].rising) continue;
    for (std::size_t k = begin; k < end; ++k) {
      const Side &own = sides[k], &other = sides[begin + end - 1 - k];
      ReliefEdge& edge = triangles_[own.triangle].edges[own.edge];
      const ReliefTriangle& neighbor = triangles_[other.triangle];
      edge.neighbor = other.triangle;
      edge.neighbor_outward =
          unit(cross(neighbor.corners[(other.edge + 1) % 3] - neighbor.corners[other.edge], neighbor.normal));
      edge.normal_limit = neighbor.normal;
      edge.stands_out = dot(triangles_[own.triangle].normal, edge.neighbor_outward) > flat;
      edge.is_own = own.triangle < other.triangle;
    }
  }
}

void Relief::find_vertices() {
  const std::size_t count = mesh_.vertices.size();
  vertex_normals_.assign(count, {});
  exposed_.assign(count, false);
  first_edge_.assign(count + 1, 0);
  for (const ReliefTriangle& triangle : triangles_) {
    for (std::size_t k = 0; k < 3; ++k) {
      vertex_normals_[triangle.vertices[k]] += triangle.normal;
      first_edge_[triangle.vertices[k] + 1] += 2;
      if (!triangle.edges[k].stands_out) continue;
      exposed_[triangle.vertices[k]] = exposed_[triangle.vertices[(k + 1) % 3]] = true;
    }
  }
  for (std::size_t i = 0; i < count; ++i) first_edge_[i + 1] += first_edge_[i];
  vertex_edges_.resize(first_edge_.back());
  std::vector<std::size_t> next(first_edge_.begin(), first_edge_.end() - 1);
  std::vector<bool> owned(count, false);
  for (ReliefTriangle& triangle : triangles_) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t vertex = triangle.vertices[k];
      triangle.owns_corner[k] = exposed_[vertex] && !owned[vertex];
      owned[vertex] = true;
      for (const std::size_t other : {(k + 1) % 3, (k + 2) % 3}) {
        vertex_edges_[next[vertex]++] = unit(triangle.corners[other] - triangle.corners[k]);
      }
    }
  }
  MUROSIMF_ASSERT(vertex_edges_.size() == first_edge_.back());
  for (Vec3d& normal : vertex_normals_) normal = unit(normal);
}

bool Relief::leads_away(std::uint32_t vertex, const Vec3d& d) const noexcept {
  const double most = flat * norm(d);
  return std::ranges::all_of(edges_of(vertex), [&](const Vec3d& edge) { return dot(edge, d) <= most; });
}

bool Relief::reaches_bottom(const ReliefTriangle& triangle) const { return bottom_ && triangle.normal.z > flat; }

/// Where the space of one triangle ends, that of its neighbor begins: above a height field straight up, else halfway between both.
void Relief::find_walls() {
  for (ReliefTriangle& triangle : triangles_) {
    for (std::size_t k = 0; k < 3; ++k) {
      ReliefEdge& edge = triangle.edges[k];
      const Vec3d along = triangle.corners[(k + 1) % 3] - triangle.corners[k];
      const bool ends = edge.neighbor < 0;
      const bool straight = reaches_bottom(triangle) && !ends && reaches_bottom(triangles_[edge.neighbor]);
      const Vec3d upright = straight ? Vec3d{0, 0, 1} : triangle.normal + (ends ? Vec3d{} : edge.normal_limit);
      edge.wall = norm(upright) > flat ? unit(cross(along, upright)) : edge.outward;
    }
  }
}

void Relief::find_depths(double thickness) {
  const std::vector<InnerDepth> depths = inner_depths(triangles_, thickness);
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    ReliefTriangle& triangle = triangles_[i];
    const auto& [a, b, c] = triangle.corners;
    triangle.prism_depth = bottom_ ? thin : depths[i].least;
    triangle.depth =
        reaches_bottom(triangle) ? triangle.normal.z * ((a.z + b.z + c.z) / 3 - *bottom_) : depths[i].middle;
    thickness_ = std::max(thickness_, triangle.depth);
  }
}

PlacedShape Relief::prism_below(const ReliefTriangle& triangle) const {
  std::array<Vec3d, 6> corners;
  for (std::size_t k = 0; k < 3; ++k) {
    corners[k] = corners[k + 3] = triangle.corners[k];
    if (reaches_bottom(triangle)) {
      corners[k + 3].z = *bottom_;
    } else {
      corners[k + 3] -= triangle.prism_depth * triangle.normal;
    }
  }
  Vec3d low = corners[0], high = corners[0];
  for (const Vec3d& p : corners) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  auto hull = std::make_shared<ConvexHull>();
  PlacedShape placed;
  placed.position = 0.5 * (low + high);
  for (const Vec3d& p : corners) hull->vertices.push_back(p - placed.position);
  hull->faces = {{0, 1, 2}, {3, 5, 4}, {0, 3, 4, 1}, {1, 4, 5, 2}, {0, 2, 5, 3}};
  for (const auto& face : hull->faces) {
    const Vec3d &p = corners[face[0]], &q = corners[face[1]], &r = corners[face[2]];
    hull->normals.push_back(unit(cross(q - p, r - p)));
  }
  hull->first_neighbor = {0, 3, 6, 9, 12, 15, 18};
  hull->neighbors = {1, 2, 3, 0, 2, 4, 0, 1, 5, 0, 4, 5, 1, 3, 5, 2, 3, 4};
  placed.shape = Convex{std::move(hull)};
  return placed;
}

Shapes Relief::prisms(const Surface& material, const Color& color) const {
  Shapes shapes;
  shapes.reserve(triangles_.size());
  for (const ReliefTriangle& triangle : triangles_) {
    PlacedShape& prism = shapes.emplace_back(prism_below(triangle));
    prism.surface = material;
    prism.color = color;
  }
  return shapes;
}

}  // namespace murosimf::collision
