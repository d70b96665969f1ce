#include "murosimf/geometry/mesh_reduction.h"

#include <algorithm>

#include "murosimf/geometry/edge_collapse.h"
#include "murosimf/geometry/vertex_clusters.h"

namespace murosimf::geometry {
namespace {

constexpr double finest = 1e-3;  // [1] first error, of the size of the largest mesh
constexpr int bisections = 7;

std::size_t count(const std::vector<TriangleMesh>& meshes) {
  std::size_t triangles = 0;
  for (const TriangleMesh& mesh : meshes) triangles += mesh.triangles.size();
  return triangles;
}

/// [m] Half the diagonal of the largest box around a mesh.
double largest_size(const std::vector<TriangleMesh>& meshes) {
  double size = 0;
  for (const TriangleMesh& mesh : meshes) {
    if (mesh.vertices.empty()) continue;
    Vec3d low = mesh.vertices[0], high = low;
    for (const Vec3d& v : mesh.vertices) {
      low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
      high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
    }
    size = std::max(size, 0.5 * norm(high - low));
  }
  return size;
}

TriangleMesh coarser(const TriangleMesh& mesh, double error) {
  TriangleMesh collapsed = collapse_edges(mesh, error), clustered = cluster_vertices(mesh, error);
  return clustered.triangles.size() < collapsed.triangles.size() ? clustered : collapsed;
}

std::vector<TriangleMesh> coarser(const std::vector<TriangleMesh>& meshes, double error) {
  std::vector<TriangleMesh> result;
  result.reserve(meshes.size());
  for (const TriangleMesh& mesh : meshes) result.push_back(coarser(mesh, error));
  return result;
}

}  // namespace

MeshReduction reduce_meshes(std::vector<TriangleMesh> meshes, std::size_t most) {
  if (count(meshes) <= most) return {std::move(meshes), 0};
  const double size = largest_size(meshes);
  if (!(size > 0)) return {std::vector<TriangleMesh>(meshes.size()), 0};  // points only
  double too_fine = 0, error = finest * size;
  std::vector<TriangleMesh> finer = std::move(meshes);
  MeshReduction best{coarser(finer, error), error};
  while (count(best.meshes) > most) {
    finer = std::move(best.meshes);
    too_fine = error;
    error *= 2;
    best = {coarser(finer, error), error};
  }
  for (int i = 0; i < bisections; ++i) {
    const double middle = 0.5 * (too_fine + best.error);
    MeshReduction tried{coarser(finer, middle), middle};
    if (count(tried.meshes) > most) {
      too_fine = middle;
    } else {
      best = std::move(tried);
    }
  }
  return best;
}

}  // namespace murosimf::geometry
