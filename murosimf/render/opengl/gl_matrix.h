/// gl_matrix.h - 4x4 matrices in OpenGL's layout, and the projections of views and lamps.
#pragma once

#include <array>

#include "murosimf/render/lamp_view.h"
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

[[nodiscard]] GlMatrix clip_of(const LampView& lamp);

}  // namespace murosimf::render
