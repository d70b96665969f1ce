/// gl_matrix.h - 4x4 matrices in OpenGL's layout, and the projections of views and lamps.
#pragma once

#include <array>

#include "murosimf/render/render_scene.h"
#include "murosimf/sensors/view_source.h"

namespace murosimf::render {

using GlMatrix = std::array<float, 16>;  ///< by columns

[[nodiscard]] GlMatrix operator*(const GlMatrix& a, const GlMatrix& b);
/// The matrix of p -> R p + r.
[[nodiscard]] GlMatrix matrix_of(const Mat3d& R, const Vec3d& r);
/// Maps -1..1 to 0..1 in all three coordinates.
[[nodiscard]] GlMatrix half_and_half();

/// Maps the optical frame to clip coordinates, rows downwards, without a farthest plane. `nearest` [m]: nearer parts are cut.
[[nodiscard]] GlMatrix clip_of(const sensors::Perspective& view, double nearest);
/// The same by parallel rays, with a range of depths for all pieces of the scene.
[[nodiscard]] GlMatrix parallel_clip_of(const sensors::Perspective& window, const RenderScene& render_scene,
                                        double ahead);

/// A view of parallel light: what it shines on lies in a box about `eye`.
struct LampView {
  Vec3d eye;                                               ///< [m] world, in the middle of the box
  Mat3d axes;                                              ///< optical axes to world axes; the third along the light
  double half_width = 1, half_height = 1, half_depth = 1;  ///< [m]
};
/// A box around all pieces of the scene, with light from `toward`; positions are extrapolated by `ahead` [s].
[[nodiscard]] LampView lamp_view(const RenderScene& render_scene, const Vec3d& toward, double ahead);
[[nodiscard]] GlMatrix clip_of(const LampView& lamp);

}  // namespace murosimf::render
