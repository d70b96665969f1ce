/// mjcf_joint.h - joints of an MJCF file: kind, axis, range, and the constants of friction and drive.
#pragma once

#include "murosimf/io/mjcf_body.h"

namespace murosimf::io {

struct MjcfJoint {
  std::string name;
  Kind kind = Kind::revolute;
  Vec3d anchor;  ///< [m] body frame
  Vec3d axis;    ///< any length but zero, body frame
  MjcfAttributes attributes;
};

/// Throws SetupError for ball joints, and for a joint without axis unless the context is lenient (then z).
[[nodiscard]] MjcfJoint read_joint(const XmlElement& element, const std::string& child_class,
                                   const MjcfContext& context);

/// Gives the last object of `chain` the joint's range, then either the servo of the table beside the file, which stands
/// for the joint's armature, damping, friction and actuators alike, or these.
void add_joint_constants(Chain& chain, const MjcfJoint& joint, const MjcfContext& context);

}  // namespace murosimf::io
