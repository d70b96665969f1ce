#include "murosimf/geometry/shrinking_mesh.h"

#include <algorithm>

namespace murosimf::geometry {

constexpr double least_turn = 0.2;  // [1] cosine of the largest angle by which a triangle may turn

ShrinkingMesh::ShrinkingMesh(const std::vector<TriangleMesh>& meshes) : meshes_(meshes.size()) {
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    const auto first = static_cast<Index>(vertices_.size());
    vertices_.insert(vertices_.end(), meshes[m].vertices.begin(), meshes[m].vertices.end());
    for (const auto& [a, b, c] : meshes[m].triangles) {
      if (a == b || b == c || c == a) continue;
      faces_.push_back({first + a, first + b, first + c});
      mesh_of_.push_back(static_cast<Index>(m));
    }
  }
  left_ = faces_.size();
  gone_.resize(faces_.size());
  around_.resize(vertices_.size());
  for (Index f = 0; f < faces_.size(); ++f) {
    for (const Index corner : faces_[f]) around_[corner].push_back(f);
  }
}

bool ShrinkingMesh::turns_a_face(Index from, Index to) const {
  for (const Index f : around_[from]) {
    if (has(f, to)) continue;
    Corners corners = faces_[f];
    const Vec3d before = normal(corners);
    std::ranges::replace(corners, from, to);
    const Vec3d after = normal(corners);
    if (dot(before, after) < least_turn * norm(before) * norm(after)) return true;
  }
  return false;
}

void ShrinkingMesh::draw_together(Index from, Index to) {
  for (const Index f : around_[from]) {
    if (has(f, to)) {
      gone_[f] = true;
      --left_;
      for (const Index corner : faces_[f]) {
        if (corner != from) std::erase(around_[corner], f);
      }
    } else {
      std::ranges::replace(faces_[f], from, to);
      around_[to].push_back(f);
    }
  }
  around_[from].clear();
}

std::vector<TriangleMesh> ShrinkingMesh::meshes() const {
  std::vector<TriangleMesh> result(meshes_);
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    if (gone_[f]) continue;
    TriangleMesh& mesh = result[mesh_of_[f]];
    const auto first = static_cast<Index>(mesh.vertices.size());
    for (const Index corner : faces_[f]) mesh.vertices.push_back(vertices_[corner]);
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  for (TriangleMesh& mesh : result) merge_vertices(mesh);
  return result;
}

}  // namespace murosimf::geometry
