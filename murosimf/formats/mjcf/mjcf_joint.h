/// mjcf_joint.h - joints of an MJCF file: kind, axis, range, spring, and the constants of friction and drive.
#pragma once

#include "murosimf/formats/mjcf/mjcf_context.h"

namespace murosimf::io {

/// Throws SetupError for ball and free joints.
[[nodiscard]] DraftJoint read_joint(const XmlElement& element, const std::string& child_class,
                                    const MjcfContext& context);

}  // namespace murosimf::io
