/// motion_file.h - reads key-frame motions (docs/motions.md).
#pragma once

#include <filesystem>
#include <string_view>

#include "murosimf/locomotion/keyframe_motion.h"

namespace murosimf::robot {

/// The file of a name: a file NAME.toml here or in `beside`, else the motion of that name in a folder `motions` here,
/// in `beside` or of the program. Throws SetupError with the nearest name.
[[nodiscard]] std::filesystem::path find_motion(std::string_view name, const std::filesystem::path& beside = {});

/// For a file with `mirror_of` the motion that it names, found beside it or as above, for the `other_side`.
/// Throws SetupError with file:line:column if the file is missing, is not TOML, or has an error: columns and values that do
/// not match, a channel that is set twice, numbers that are not finite, durations that are not positive, an impossible place
/// of the ball, a mirror image of a mirror image.
[[nodiscard]] locomotion::KeyframeMotion read_motion(const std::filesystem::path& file);

}  // namespace murosimf::robot
