/// mjcf_relations.h - relations between parts of a robot in an MJCF file: coupled joints (`equality/joint`), contacts
/// that are excluded or requested (`contact`), and sensors.
#pragma once

#include "murosimf/robot_formats/mjcf/mjcf_defaults.h"
#include "murosimf/robot_formats/mjcf/mjcf_names.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot_formats::mjcf {

/// Fills mimics, exclusions, pairs and sensors of `description`, after its bodies are read. Throws SetupError for unknown names,
/// for a coupling that is not linear, and for a contact pair with a visual mesh.
/// A geom with masks for the floor of the file, but not for a usual one, becomes of kind 1 as well: the scene brings its
/// own floor. A geom that is paired with one outside the robot, like the floor, collides independent of its masks.
void read_relations(const files::XmlElement& root, const MjcfNames& names, const MjcfDefaults& defaults,
                    robot_formats::RobotDescription& description);

}  // namespace murosimf::robot_formats::mjcf
