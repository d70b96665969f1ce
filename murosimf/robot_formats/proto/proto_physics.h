/// proto_physics.h - the mass of a Solid of a PROTO file.
///
/// `mass`, else `density` times the volume of the boundingObject; all its parts count, overlaps twice. Center and inertia are those of
/// `centerOfMass` and `inertiaMatrix` (Ixx Iyy Izz Ixy Ixz Iyz, at the center, axes of the Solid), else those of the boundingObject
/// with that mass.
/// Source: Webots reference manual, "Physics".
#pragma once

#include <vector>

#include "murosimf/robot_formats/mass_properties.h"
#include "murosimf/robot_formats/proto/proto_log.h"

namespace murosimf::robot_formats::proto {

/// `bounding`: the parts of the boundingObject at density 1 kg/m^3, axes of the Solid. Throws SetupError (file:line) for impossible
/// body has.
[[nodiscard]] robot_formats::MassProperties read_physics(const Node& physics,
                                                         const std::vector<robot_formats::MassProperties>& bounding,
                                                         ProtoLog& log);

}  // namespace murosimf::robot_formats::proto
