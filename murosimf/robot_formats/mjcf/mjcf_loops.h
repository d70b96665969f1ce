/// mjcf_loops.h - loops of a robot: MJCF's `equality/connect` (two points coincide) and `equality/weld` (their axes as well).
///
/// Both ends become frames: of bodies, `<loop>.end1` and `<loop>.end2`; where the file names sites, those. `connect` has its anchor in
/// body1, and in body2 its place in the pose of the file; `weld` has the anchor in body2 and `relpose` in body1, or the relative pose in
/// the pose of the file.
/// Source: XML reference of the MuJoCo documentation, equality.
#pragma once

#include "murosimf/files/xml_element.h"
#include "murosimf/robot_formats/mjcf/mjcf_names.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot_formats::mjcf {

/// Fills loops and their frames of `description`, after its bodies are read; those that mjcf_idle.h reports are skipped. Throws SetupError
/// for unknown names. A loop that the pose of the file leaves open by a millimeter or a degree is a warning.
void read_loops(const files::XmlElement& root, const MjcfNames& names, robot_formats::RobotDescription& description);

}  // namespace murosimf::robot_formats::mjcf
