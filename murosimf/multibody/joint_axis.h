/// joint_axis.h - a joint's axis in the axes of whatever its link is seen from.
#pragma once

#include "murosimf/model/tree.h"

namespace murosimf::multibody {

/// R * link.axis for the link's orientation R; coordinate axes cost nothing.
template <class S>
MUROSIMF_INLINE Vec3<S> joint_axis(const Mat3<S>& R, const Link& link) {
  switch (link.axis_kind) {
    case AxisKind::x: return R.x;
    case AxisKind::y: return R.y;
    case AxisKind::z: return R.z;
    case AxisKind::general: break;
  }
  return R * link.axis;
}

}  // namespace murosimf::multibody
