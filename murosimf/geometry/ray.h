/// ray.h - where a ray meets a shape: exact for every kind.
#pragma once

#include <optional>

#include "murosimf/geometry/manifold.h"
#include "murosimf/model/shape.h"

namespace murosimf::geometry {

struct Ray {
  Vec3d origin;              ///< [m]
  Vec3d direction{1, 0, 0};  ///< [1] unit
};

/// Where a ray comes to a surface.
struct RayEntry {
  double distance = 0;  ///< [m] from the ray's origin
  Vec3d normal;         ///< [1] of the surface, unit, outwards
};

/// The first point of the shape on the ray, in the frame of `at` and `ray`; nothing if the ray misses it. A ray that
/// starts inside a shape meets it at distance 0, with the normal against the ray.
[[nodiscard]] std::optional<RayEntry> meet(const Ray& ray, const Shape& shape, const Transformd& at);

}  // namespace murosimf::geometry
