/// mesh_entry.h - meshes that shapes of a robot file name by file and scale: each is one entry of the description.
#pragma once

#include <filesystem>
#include <string>

#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot_formats {

/// The entry of this file at this scale; a new one is called as the file, `<name>_2` where that is taken. `where` [file:line] names it first.
[[nodiscard]] MeshDescription mesh_entry(RobotDescription& robot, const std::filesystem::path& file, const Vec3d& scale,
                                         const std::string& where);

}  // namespace murosimf::robot_formats
