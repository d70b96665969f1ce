/// urdf_inertial.h - masses of links of a URDF file.
#pragma once

#include "murosimf/robot_formats/robot_description.h"
#include "murosimf/robot_formats/urdf/urdf_tree.h"

namespace murosimf::robot_formats::urdf {

/// Mass, center and inertia of a link, link axes; all zero without an `inertial`. An inertia of zero is a point mass, as of
/// many frames. `balance`: impossible inertias become their mean in all directions, by the compiler option
/// balanceinertia; otherwise they are a warning. Throws SetupError for a negative mass.
[[nodiscard]] robot_formats::MassProperties read_inertial(const UrdfLink& link, bool balance, UrdfLog& log);

}  // namespace murosimf::robot_formats::urdf
