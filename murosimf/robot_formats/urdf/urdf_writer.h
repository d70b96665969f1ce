/// urdf_writer.h - writes a description of a robot as a URDF file.
///
/// One link for each body, at the joint above it; bodies of several joints get massless links between them, frames (sites, cameras) are
/// links at fixed joints. SI units and radians; masses as inertials at their centers; friction, springs and sensors in gazebo blocks.
/// read_urdf makes the same robot of it, except for the parts in `left_out`, which URDF cannot express. Links with a joint that is not at
/// the body's origin have their frames at the joint.
/// Sources: URDF XML specification, "link" and "joint"; SDFormat specification, "sensor".
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot_formats::urdf {

struct UrdfWriterOptions {
  std::filesystem::path folder{};      ///< folder of the future file: mesh files are named relative to it
  std::string mesh_folder = "meshes";  ///< below it: folder of meshes without a file
};

struct UrdfText {
  std::string text;                           ///< of the URDF file
  std::map<std::string, std::string> meshes;  ///< OBJ texts by name relative to `folder`: to be written beside it
  std::vector<std::string> left_out;          ///< one line each: parts that URDF cannot express
};

/// Bodies without joints may be welded already.
[[nodiscard]] UrdfText to_urdf(const robot_formats::RobotDescription& description,
                               const UrdfWriterOptions& options = {});

/// Whether the writer can write all of the sensor.
[[nodiscard]] bool is_urdf_sensor(const robot_formats::SensorDescription& sensor);

}  // namespace murosimf::robot_formats::urdf
