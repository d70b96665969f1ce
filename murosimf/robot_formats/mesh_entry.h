/// mesh_entry.h - entries of meshes that shapes of a robot file refer to by file and scale.
#pragma once

#include <filesystem>
#include <string>

#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot_formats {

/// The entry of this file at this scale; a new one is named after the file, `<name>_2` if that is taken. `where` [file:line] refers to it first.
[[nodiscard]] MeshDescription mesh_entry(RobotDescription& robot, const std::filesystem::path& file, const Vec3d& scale,
                                         const std::string& where);

}  // namespace murosimf::robot_formats
