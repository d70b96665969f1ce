/// joint_axis.h - a joint's axis in the axes of the frame that its link's orientation refers to.
#pragma once

#include "murosimf/math/assert.h"
#include "murosimf/model/tree.h"

namespace murosimf::multibody {

/// R * link.axis for the link's orientation R; coordinate axes need no multiplication.
template <class S>
MUROSIMF_INLINE Vec3<S> joint_axis(const Mat3<S>& R, const Link& link) {
  MUROSIMF_ASSERT(link.kind != LinkKind::base);
  switch (link.axis_kind) {
    case AxisKind::x: return R.x;
    case AxisKind::y: return R.y;
    case AxisKind::z: return R.z;
    case AxisKind::general: break;
  }
  return R * link.axis;
}

}  // namespace murosimf::multibody
