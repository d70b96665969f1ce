/// mjcf_joint.h - joints of an MJCF file: kind, axis, range, spring, and the constants of friction and drive.
#pragma once

#include "murosimf/formats/mjcf/mjcf_children.h"
#include "murosimf/formats/mjcf/mjcf_context.h"

namespace murosimf::formats::mjcf {

/// Throws SetupError for ball and free joints.
[[nodiscard]] description::JointDescription read_joint(const MjcfChild& child, const MjcfContext& context);

}  // namespace murosimf::formats::mjcf
