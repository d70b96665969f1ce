/// mjcf_writer.h - a description of a robot as an MJCF file in our normal form.
///
/// One file that needs no other one but meshes: SI units and radians, no default classes, no includes, orientations as
/// quaternions, all masses as inertials, visual shapes without contact in group 2. What has its default value in
/// MJCF is left out. Springs, couplings, contact filters and actuators are written as MuJoCo has them.
/// read_mjcf makes the same robot of it: lengths and masses to the last bit, orientations and places of meshes within 1e-15. What MJCF has no
/// words for stands in comments (sensors) or is missing (rate limits of joints).
/// Visual meshes that are not there, or neither STL nor OBJ, are left out with a comment.
/// Source: XML reference of the MuJoCo documentation.
#pragma once

#include <filesystem>
#include <string>

#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot_formats::mjcf {

struct MjcfWriterOptions {
  std::filesystem::path folder{};  ///< where the file will stand: mesh files are named relative to it
};

/// Bodies without joints may be welded already; what is left of them are frames. Shapes that share a name stay apart:
/// the first keeps it.
[[nodiscard]] std::string to_mjcf(const robot_formats::RobotDescription& description,
                                  const MjcfWriterOptions& options = {});

}  // namespace murosimf::robot_formats::mjcf
