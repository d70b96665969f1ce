/// sphere_contact.h - a sphere against any shape, in closed form.
#pragma once

#include <optional>

#include "murosimf/model/shape.h"

namespace murosimf::geometry {

/// Where a sphere touches another shape.
struct SphereContact {
  Vec3d point;       ///< [m] on the other shape's surface
  Vec3d normal;      ///< [1] unit, from the other shape to the sphere
  double depth = 0;  ///< [m] overlap along the normal, positive
};

/// `center` [m] and `radius` [m] of the sphere, in the frame of the other shape; so is the result.
[[nodiscard]] std::optional<SphereContact> sphere_contact(const Vec3d& center, double radius, const Shape& other);

}  // namespace murosimf::geometry
