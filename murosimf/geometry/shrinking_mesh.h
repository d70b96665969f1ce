/// shrinking_mesh.h - several meshes whose vertices are drawn together one after the other, with the triangles around
/// each vertex at hand.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "murosimf/geometry/triangle_mesh.h"

namespace murosimf::geometry {

class ShrinkingMesh {
 public:
  using Index = std::uint32_t;
  using Corners = std::array<Index, 3>;

  /// Triangles with two corners in one vertex are left out.
  explicit ShrinkingMesh(const std::vector<TriangleMesh>& meshes);

  [[nodiscard]] std::span<const Vec3d> vertices() const { return vertices_; }
  [[nodiscard]] std::span<const Corners> faces() const { return faces_; }  ///< those that are gone, too
  [[nodiscard]] std::size_t left() const { return left_; }                 ///< triangles that are not gone
  /// Triangles around a vertex; none if it is gone.
  [[nodiscard]] std::span<const Index> around(Index vertex) const { return around_[vertex]; }
  /// Normal of a triangle, as long as twice its area.
  [[nodiscard]] Vec3d normal(const Corners& c) const {
    return cross(vertices_[c[1]] - vertices_[c[0]], vertices_[c[2]] - vertices_[c[0]]);
  }
  [[nodiscard]] bool has(Index face, Index vertex) const {
    const Corners& c = faces_[face];
    return c[0] == vertex || c[1] == vertex || c[2] == vertex;
  }
  /// A triangle around `from` would turn by more than about 80 degrees if it were drawn to `to`.
  [[nodiscard]] bool turns_a_face(Index from, Index to) const;

  /// Triangles of `from` get the corner `to` instead; those that have both are gone, and so is `from`. A corner that moves gets the place
  /// in the picture that `to` has on the same side of a seam, as a triangle that is gone says; without such a one it keeps its own.
  void draw_together(Index from, Index to);

  /// Both triangles have the same places in a picture at their common corners `a` and `b`, or none.
  [[nodiscard]] bool share_places(Index one, Index other, Index a, Index b) const;

  /// What is left, in the order of the given meshes.
  [[nodiscard]] std::vector<TriangleMesh> meshes() const;

 private:
  [[nodiscard]] std::array<float, 2>& place_of(Index face, Index vertex);
  void move_places(Index from, Index to);

  std::vector<Vec3d> vertices_;
  std::vector<Corners> faces_;
  std::vector<PicturePlaces> places_;  // of each face; empty if no mesh has some
  std::vector<bool> has_places_;       // of each mesh
  std::vector<Index> mesh_of_;         // of each face
  std::vector<bool> gone_;             // of each face
  std::vector<std::vector<Index>> around_;
  std::size_t left_ = 0, meshes_ = 0;
};

}  // namespace murosimf::geometry
