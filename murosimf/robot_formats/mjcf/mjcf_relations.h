/// mjcf_relations.h - what an MJCF file says about parts of a robot together: coupled joints (`equality/joint`), contacts
/// that are excluded or wanted (`contact`), and sensors.
#pragma once

#include "murosimf/robot_formats/mjcf/mjcf_defaults.h"
#include "murosimf/robot_formats/mjcf/mjcf_names.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot_formats::mjcf {

/// Fills mimics, exclusions, pairs and sensors of `description`, whose bodies are read already. Throws SetupError for unknown names,
/// for a coupling that is not linear, and for a contact pair with a mesh that is only looked at.
/// A geom whose masks let it touch the floor of the file, but not a usual one, becomes of kind 1, too: the scene brings its
/// own floor. A geom that is paired with one outside the robot, like the floor, collides from now on whatever its masks say.
void read_relations(const files::XmlElement& root, const MjcfNames& names, const MjcfDefaults& defaults,
                    robot_formats::RobotDescription& description);

}  // namespace murosimf::robot_formats::mjcf
