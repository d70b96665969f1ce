/// proto_reader.h - a robot from a PROTO file of Webots, or from a world with one robot.
///
/// Every Solid, and every device that is one, becomes a body: at the end of a joint with that joint, else fixed to its parent. The
/// Robot is the base; without Physics it is bolted to the world, as in Webots. The robot's own place is ignored: the scene places
/// robots. Fields of the PROTO have their default values (proto_file.h). Parts of a robot touch each other only with `selfCollision`.
/// Servos are not made here: motors give a joint's largest torque and rate. Parts without effect become notes; an unknown node, which
/// might have a mass, is an error (a warning with `lenient`).
/// Source: Webots reference manual, "Nodes and API Functions", "Physics".
#pragma once

#include <filesystem>

#include "murosimf/robot_formats/reader_options.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot_formats::proto {

/// Throws SetupError: file, line, what is wrong, what to do.
[[nodiscard]] robot_formats::RobotDescription read_proto(const std::filesystem::path& file,
                                                         const robot_formats::ReaderOptions& options = {});

}  // namespace murosimf::robot_formats::proto
