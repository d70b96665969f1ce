/// lamp_view.h - what a lamp far away sees of a scene: where shadows may fall.
#pragma once

#include "murosimf/math/mat3.h"
#include "murosimf/render/render_scene.h"

namespace murosimf::render {

/// Bounds of all pieces [m] along some axes; without pieces it is empty.
struct PieceBounds {
  Vec3d low{1e9, 1e9, 1e9}, high{-1e9, -1e9, -1e9};
  [[nodiscard]] bool empty() const { return low.x > high.x; }
};
/// Of pieces whose position is finite; positions are extrapolated by `ahead` [s].
[[nodiscard]] PieceBounds bounds_of(const RenderScene& render_scene, const Mat3d& axes, double ahead);

/// A view of parallel light: what it shines on lies in a box about `eye`.
struct LampView {
  Vec3d eye;                                               ///< [m] world, in the middle of the box
  Mat3d axes;                                              ///< optical axes to world axes; the third along the light
  double half_width = 1, half_height = 1, half_depth = 1;  ///< [m]
};
/// A box around all pieces of the scene, with light from `toward`; positions are extrapolated by `ahead` [s].
[[nodiscard]] LampView lamp_view(const RenderScene& render_scene, const Vec3d& toward, double ahead);

}  // namespace murosimf::render
