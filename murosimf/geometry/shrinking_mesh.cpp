#include "murosimf/geometry/shrinking_mesh.h"

#include <algorithm>

#include "murosimf/math/assert.h"

namespace murosimf::geometry {

constexpr double least_turn = 0.2;  // [1] cosine of the largest angle by which a triangle may turn

ShrinkingMesh::ShrinkingMesh(const std::vector<TriangleMesh>& meshes) : meshes_(meshes.size()) {
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    const auto first = static_cast<Index>(vertices_.size());
    vertices_.insert(vertices_.end(), meshes[m].vertices.begin(), meshes[m].vertices.end());
    has_places_.push_back(!meshes[m].places.empty());
    for (std::size_t i = 0; i < meshes[m].triangles.size(); ++i) {
      const auto& [a, b, c] = meshes[m].triangles[i];
      if (a == b || b == c || c == a) continue;
      if (has_places_.back()) {
        places_.resize(faces_.size());
        places_.push_back(meshes[m].places[i]);
      }
      faces_.push_back({first + a, first + b, first + c});
      mesh_of_.push_back(static_cast<Index>(m));
    }
  }
  if (!places_.empty()) places_.resize(faces_.size());
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

std::array<float, 2>& ShrinkingMesh::place_of(Index face, Index vertex) {
  const Corners& c = faces_[face];
  MUROSIMF_ASSERT(has(face, vertex));
  return places_[face][c[0] == vertex ? 0 : c[1] == vertex ? 1 : 2];
}

bool ShrinkingMesh::share_places(Index one, Index other, Index a, Index b) const {
  if (places_.empty()) return true;
  const auto place = [&](Index face, Index vertex) {
    const Corners& c = faces_[face];
    return places_[face][c[0] == vertex ? 0 : c[1] == vertex ? 1 : 2];
  };
  return place(one, a) == place(other, a) && place(one, b) == place(other, b);
}

/// Source: Hoppe, "New quadric metric for simplifying meshes with appearance attributes", IEEE Visualization 1999: wedges.
void ShrinkingMesh::move_places(Index from, Index to) {
  for (const Index f : around_[from]) {
    if (has(f, to)) continue;
    std::array<float, 2>& place = place_of(f, from);
    for (const Index gone : around_[from]) {
      if (!has(gone, to) || place_of(gone, from) != place) continue;
      place = place_of(gone, to);
      break;
    }
  }
}

void ShrinkingMesh::draw_together(Index from, Index to) {
  if (!places_.empty()) move_places(from, to);
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
    if (has_places_[mesh_of_[f]]) mesh.places.push_back(places_[f]);
  }
  for (TriangleMesh& mesh : result) merge_vertices(mesh);
  return result;
}

}  // namespace murosimf::geometry
