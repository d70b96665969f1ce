/// transform.h - where a frame is in another one.
#pragma once

#include "murosimf/math/mat3.h"

namespace murosimf {

/// A frame seen from another one.
template <class S>
struct Transform {
  Vec3<S> position;     ///< [m] of its origin
  Mat3<S> orientation;  ///< its axes to the axes of the other
};
using Transformd = Transform<double>;

/// `inner` stands in the frame of `outer`: where it is in the frame that `outer` is in.
template <class S>
[[nodiscard]] Transform<S> operator*(const Transform<S>& outer, const Transform<S>& inner) {
  return {outer.position + outer.orientation * inner.position, outer.orientation * inner.orientation};
}

}  // namespace murosimf
