/// mjcf_inertia.h - mass, center and inertia of a body: from its `inertial` element, or from its geoms.
#pragma once

#include <string>
#include <vector>

#include "murosimf/robot_formats/mass_properties.h"
#include "murosimf/robot_formats/mjcf/mjcf_geom.h"

namespace murosimf::robot_formats::mjcf {

/// Whether the geoms of `body` give its mass, by its inertial and the compiler settings.
[[nodiscard]] bool mass_from_geoms(const files::XmlElement& body, const MjcfCompiler& compiler);

/// Mass of `body`: of its inertial or its solids, by the compiler settings, and not below their bounds. Zero mass if
/// it has neither. Throws SetupError for an impossible mass or inertia; an inertia that breaks the triangle
/// inequality (the sum of two principal moments is less than the third) is a line in `warnings`.
[[nodiscard]] robot_formats::MassProperties read_mass(const files::XmlElement& body,
                                                      const std::vector<robot_formats::MassProperties>& solids,
                                                      const MjcfCompiler& compiler, std::vector<std::string>& warnings);

}  // namespace murosimf::robot_formats::mjcf
