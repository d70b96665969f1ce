/// urdf_transmission.h - `transmission` elements of a URDF file: they are not used, because servos are described
/// on the output side of their gears; errors in them are reported.
#pragma once

#include "murosimf/robot_formats/urdf/urdf_tree.h"

namespace murosimf::robot_formats::urdf {

/// Reports gear ratios that are not 1, warns about joints that do not exist.
void read_transmissions(const files::XmlElement& robot, const UrdfTree& tree, UrdfLog& log);

}  // namespace murosimf::robot_formats::urdf
