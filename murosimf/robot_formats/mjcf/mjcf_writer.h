/// mjcf_writer.h - writes a description of a robot as an MJCF file in normal form.
///
/// One file that needs only mesh files besides: SI units and radians, no default classes, no includes, orientations as
/// quaternions, all masses as inertials, visual shapes without contact in group 2. Default values of
/// MJCF are omitted. Springs, couplings, contact filters and actuators are written in MuJoCo's own form.
/// read_mjcf makes the same robot of it: lengths and masses to the last bit, orientations and places of meshes within 1e-15. Parts that MJCF
/// cannot express are comments (sensors) or missing (rate limits of joints).
/// Visual meshes that do not exist, or are neither STL nor OBJ, are omitted with a comment.
/// Source: XML reference of the MuJoCo documentation.
#pragma once

#include <filesystem>
#include <string>

#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot_formats::mjcf {

struct MjcfWriterOptions {
  std::filesystem::path folder{};  ///< folder of the future file: mesh files are named relative to it
};

/// Bodies without joints may be welded already; then only their frames remain. Of shapes with the same name
/// only the first keeps it.
[[nodiscard]] std::string to_mjcf(const robot_formats::RobotDescription& description,
                                  const MjcfWriterOptions& options = {});

}  // namespace murosimf::robot_formats::mjcf
