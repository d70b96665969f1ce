#include "murosimf/geometry/edge_collapse.h"

#include <meshoptimizer.h>

namespace murosimf::geometry {
namespace {

std::vector<float> positions_of(const TriangleMesh& mesh) {
  std::vector<float> positions;
  positions.reserve(3 * mesh.vertices.size());
  for (const Vec3d& v : mesh.vertices) {
    for (const double number : {v.x, v.y, v.z}) positions.push_back(static_cast<float>(number));
  }
  return positions;
}

std::vector<unsigned int> corners_of(const TriangleMesh& mesh) {
  std::vector<unsigned int> corners;
  corners.reserve(3 * mesh.triangles.size());
  for (const auto& triangle : mesh.triangles) corners.insert(corners.end(), triangle.begin(), triangle.end());
  return corners;
}

}  // namespace

bool can_collapse_edges() { return true; }

TriangleMesh collapse_edges(const TriangleMesh& mesh, double error) {
  if (mesh.triangles.empty()) return mesh;
  const auto positions = positions_of(mesh);
  auto corners = corners_of(mesh);
  const std::size_t count = mesh.vertices.size(), stride = 3 * sizeof(float);
  const float scale = meshopt_simplifyScale(positions.data(), count, stride);
  if (!(scale > 0)) return {};
  const std::vector<unsigned int> before = corners;
  corners.resize(meshopt_simplify(corners.data(), before.data(), before.size(), positions.data(), count, stride, 0,
                                  static_cast<float>(error) / scale, 0, nullptr));
  TriangleMesh coarse{mesh.vertices, {}};
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    coarse.triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
  }
  merge_vertices(coarse);
  return coarse;
}

}  // namespace murosimf::geometry
