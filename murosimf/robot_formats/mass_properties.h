/// mass_properties.h - mass, center and inertia of shapes, and of several parts together.
#pragma once

#include <vector>

#include "murosimf/model/shape.h"

namespace murosimf::robot_formats {

/// Mass, center and inertia of a body or of a part of it.
struct MassProperties {
  double mass = 0;   ///< [kg]
  Vec3d center;      ///< [m] body frame
  SymMat3d inertia;  ///< [kg m^2] at the center, body axes
};

/// [m^3]; zero for a plane.
[[nodiscard]] double volume(const Shape& shape);
/// [kg m^2] of a homogeneous solid of unit mass, at its center of mass, shape axes; zero for a plane.
[[nodiscard]] SymMat3d unit_inertia(const Shape& shape);
/// Properties of several parts together: center by weights, inertia by the parallel-axis theorem.
[[nodiscard]] MassProperties combined(const std::vector<MassProperties>& parts);

/// Properties in the frame in which the body is at `position` [m] with `orientation` (body axes to the frame's axes).
[[nodiscard]] MassProperties moved(const MassProperties& body, const Vec3d& position, const Mat3d& orientation);
/// [kg m^2] in rising order.
[[nodiscard]] Vec3d principal_moments(const SymMat3d& inertia);
/// Whether the sum of the two smaller moments is less than the largest, by more than the six digits of files: no
/// solid body has such moments. `moments` in rising order.
[[nodiscard]] bool breaks_triangle_inequality(const Vec3d& moments);
/// A tensor with the same principal axes; moments below `least` [kg m^2] are raised to it.
[[nodiscard]] SymMat3d with_least_moment(const SymMat3d& inertia, double least);

}  // namespace murosimf::robot_formats
