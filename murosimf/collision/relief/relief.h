/// relief.h - uneven ground as triangles with their neighbors: height fields, and meshes that need not be convex.
///
/// The solid below a triangle is a prism, the shape for rays, regions and trees of volumes. Contacts are those of the triangles
/// (relief_contact.h), so that edges within flat or concave parts have no effect.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "murosimf/geometry/triangle_mesh.h"
#include "murosimf/model/property.h"
#include "murosimf/model/shape.h"

namespace murosimf::collision {

/// The edge of a triangle from corner k to corner k + 1.
struct ReliefEdge {
  int neighbor = -1;        ///< the triangle behind it; -1: the surface ends there
  bool stands_out = false;  ///< a ridge, or a border: bodies can touch it and neither face
  Vec3d outward;            ///< [1] unit, in the triangle's plane, out of it
  Vec3d neighbor_outward;   ///< [1] the same of the neighbor; at a border the normal
  Vec3d normal_limit;       ///< [1] the neighbor's normal; at a border `outward`
  Vec3d wall;           ///< [1] unit, of the plane through the edge up to which the triangle's space reaches, out of it
  bool is_own = false;  ///< of two triangles, one tests their common edge
};

struct ReliefTriangle {
  std::array<Vec3d, 3> corners;  ///< [m] counterclockwise seen from outside
  Vec3d normal;                  ///< [1] unit, outwards
  std::array<ReliefEdge, 3> edges;
  std::array<std::uint32_t, 3> vertices{};  ///< of Relief::mesh()
  std::array<bool, 3> owns_corner{};        ///< of all triangles around it, one tests a corner that is_exposed
  double depth = 0;                         ///< [m] extent of its space below it, along the normal
  double prism_depth = 0;                   ///< [m] of the prism below it
};

class Relief {
 public:
  struct Options {
    double thickness = 0.1;  ///< [m] of the prisms, across their triangles; less where the solid is thinner
    std::optional<double>
        bottom;  ///< [m] z down to which the prisms of triangles that look upwards reach instead, all straight down
  };

  /// Corners at one place are one. Triangles without area are left out. Throws SetupError if none is left, or a number is not finite.
  Relief(geometry::TriangleMesh mesh, const Options& options);

  [[nodiscard]] const geometry::TriangleMesh& mesh() const { return mesh_; }
  [[nodiscard]] const std::vector<ReliefTriangle>& triangles() const { return triangles_; }
  /// [1] unit: mean of the faces around a vertex.
  [[nodiscard]] const Vec3d& vertex_normal(std::uint32_t vertex) const { return vertex_normals_[vertex]; }
  /// [1] unit, of the edges out of a vertex.
  [[nodiscard]] std::span<const Vec3d> edges_of(std::uint32_t vertex) const {
    return std::span(vertex_edges_).subspan(first_edge_[vertex], first_edge_[vertex + 1] - first_edge_[vertex]);
  }
  /// True if an edge that stands out ends there: bodies can touch the corner itself.
  [[nodiscard]] bool is_exposed(std::uint32_t vertex) const { return exposed_[vertex]; }
  /// True if `d` leads away from the surface at the vertex, so that no face or edge around it is nearer than the vertex itself.
  [[nodiscard]] bool leads_away(std::uint32_t vertex, const Vec3d& d) const noexcept;

  /// [m] of the thickest prism.
  [[nodiscard]] double thickness() const { return thickness_; }

  /// The prism below each triangle, in their order, in the surface's frame; all of that material and color.
  [[nodiscard]] Shapes prisms(const Surface& material, const Color& color) const;

 private:
  void find_triangles();
  void find_neighbors();
  void find_vertices();
  void find_depths(double thickness);
  void find_walls();
  [[nodiscard]] bool reaches_bottom(const ReliefTriangle& triangle) const;
  [[nodiscard]] PlacedShape prism_below(const ReliefTriangle& triangle) const;

  geometry::TriangleMesh mesh_;
  std::vector<ReliefTriangle> triangles_;
  std::vector<Vec3d> vertex_normals_;
  std::vector<std::size_t> first_edge_;
  std::vector<Vec3d> vertex_edges_;
  std::vector<bool> exposed_;
  std::optional<double> bottom_;
  double thickness_ = 0;
};

using ReliefPtr = std::shared_ptr<const Relief>;

}  // namespace murosimf::collision

namespace murosimf::properties {

/// Its shapes are the prisms below the triangles, one for each, in their order.
inline constexpr Property<collision::ReliefPtr> relief{
    {"relief", "m", "object", "uneven ground: the triangles that its shapes lie below"}};

}  // namespace murosimf::properties
