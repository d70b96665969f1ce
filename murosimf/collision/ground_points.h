/// ground_points.h - where the shapes of one model touch an infinite plane: exact, one to eight points per shape.
#pragma once

#include <span>
#include <vector>

#include "murosimf/collision/contact.h"
#include "murosimf/model/model.h"
#include "murosimf/model/shape.h"

namespace murosimf::collision {

/// A static plane: all points x with normal . x < height are inside the ground.
struct GroundPlane {
  Vec3d normal{0, 0, 1};     ///< [1] unit, world frame
  double height = 0;         ///< [m]
  Vec3d friction_direction;  ///< [1] where the pile leans: unit, in the plane, world frame; or zero
  Surface surface;
  int object = 0;                                        ///< of the environment
  std::uint32_t contact_type = 1, contact_affinity = 1;  ///< model/shape.h
};

/// The points of one shape that can touch a plane first.
struct GroundShape {
  int object = 0;
  PlacedShape placed;
  double reach = 0;         ///< [m] bounding radius about the shape's origin
  double object_reach = 0;  ///< [m] bounding radius about the object's origin: cheap to test, in any attitude
  std::uint32_t first_feature = 0;
};

[[nodiscard]] GroundShape ground_shape(int object, const PlacedShape& placed, std::uint32_t first_feature);

/// Every one of colliding_shapes(model), in that order. The model keeps the list, for all equal robots.
[[nodiscard]] const std::vector<GroundShape>& ground_shapes(const Model& model);

/// Numbers that the features of one shape take: eight, more for a polyhedron of more vertices.
[[nodiscard]] std::uint32_t features_of(const Shape& shape);

/// Number of features of all shapes of one model, in their order.
[[nodiscard]] inline std::uint64_t features_of_all(std::span<const GroundShape> shapes) {
  return shapes.empty() ? 0 : shapes.back().first_feature + features_of(shapes.back().placed.shape);
}

/// Whether a shape cannot touch the plane in any attitude, with its object at r [m]: true for most shapes, at the cost of one product.
[[nodiscard]] inline bool is_out_of_reach(const GroundShape& shape, const Vec3d& r, const GroundPlane& plane) {
  return dot(plane.normal, r) - plane.height > shape.object_reach;
}

/// Appends the contacts of `shape` with `plane`. False if the bounding spheres exclude any. r [m], R: pose of its object, world frame.
/// The caller fills in the numbers of the pair: `surface`, velocities and memory.
bool find_ground_contacts(const GroundShape& shape, const Vec3d& r, const Mat3d& R, const GroundPlane& plane,
                          std::vector<ContactPoint>& found);

/// Height [m] of the lowest point of `shape` above the plane.
[[nodiscard]] double lowest_point(const GroundShape& shape, const Vec3d& r, const Mat3d& R, const GroundPlane& plane);

}  // namespace murosimf::collision
