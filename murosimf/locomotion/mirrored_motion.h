/// mirrored_motion.h - a key-frame motion for the other side.
///
/// The x-z plane of the base is the mirror. Joints are paired by their places with all joints at zero: a hinge at (x, y, z)
/// with axis (a, b, c) belongs to the one at (x, -y, z) with axis (-a, b, -c), since an axis of rotation is a pseudovector; a slide's
/// axis becomes (a, -b, c). Where the partner's axis points the other way the value changes its sign. Joints in the plane are their
/// own partners. Left and right foot change places; y changes its sign, also that of a ball.
#pragma once

#include "murosimf/locomotion/keyframe_motion.h"
#include "murosimf/model/model.h"

namespace murosimf::locomotion {

/// The joint (object) that moves on the other side as `joint` does, and the sign of its values.
struct MirroredJoint {
  int joint = 0;
  double sign = 1;
};

/// Throws SetupError if no joint of the model is the mirror image of this one, within 5 mm and 8 degrees.
[[nodiscard]] MirroredJoint mirrored_joint(const Model& model, int joint);

/// The motion mirrored; `other_side` stays as it is. Throws SetupError as mirrored_joint, and for unknown joints.
[[nodiscard]] KeyframeMotion mirrored(const KeyframeMotion& motion, const Model& model);

/// The motion as the model plays it: the motion itself or, where it is for the `other_side`, mirrored.
[[nodiscard]] KeyframeMotion played_by(const Model& model, const KeyframeMotion& motion);

}  // namespace murosimf::locomotion
