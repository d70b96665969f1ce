/// robot_picture.h - pictures of a robot file: from the front, from its left side, from above and from an angle.
#pragma once

#include <string>

#include "murosimf/imaging/image.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::appearance {

/// The robot in the pose of the file, four times in a row to the same scale. Bodies are drawn with
/// their visual meshes, or else with the shapes that collide. Meshes that cannot be read are left out. Throws
/// SetupError if this machine or this build cannot draw.
[[nodiscard]] imaging::ColorImage robot_picture(const robot_formats::RobotDescription& description, int columns = 1600,
                                                int rows = 640);
/// The same with a title, as the bytes of a PNG file.
[[nodiscard]] std::string robot_picture_png(const robot_formats::RobotDescription& description);

}  // namespace murosimf::appearance
