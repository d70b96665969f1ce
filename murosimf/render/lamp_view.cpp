#include "murosimf/render/lamp_view.h"

#include <algorithm>
#include <cmath>

#include "murosimf/math/assert.h"

namespace murosimf::render {

PieceBounds bounds_of(const RenderScene& render_scene, const Mat3d& axes, double ahead) {
  PieceBounds bounds;
  Vec3d &low = bounds.low, &high = bounds.high;
  render_scene.for_drawables(ahead, [&](const Drawable& drawable, const Transformd& pose) {
    const Vec3d p = transposed_times(axes, pose.position);
    const double r = drawable.radius;
    // A robot that was frozen after a blow-up must not take the shadows of the others with it.
    if (!std::isfinite(norm(p) + r)) return;
    low = {std::min(low.x, p.x - r), std::min(low.y, p.y - r), std::min(low.z, p.z - r)};
    high = {std::max(high.x, p.x + r), std::max(high.y, p.y + r), std::max(high.z, p.z + r)};
  });
  return bounds;
}

LampView lamp_view(const RenderScene& render_scene, const Vec3d& toward, double ahead) {
  MUROSIMF_ASSERT(norm(toward) > 0);
  LampView lamp;
  lamp.axes.z = (-1 / norm(toward)) * toward;
  // The axis that is farther from the direction of the light: the cross product does not vanish.
  const Vec3d side = std::abs(toward.x) < std::abs(toward.y) ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
  const Vec3d x = cross(side, lamp.axes.z);
  lamp.axes.x = (1 / norm(x)) * x;
  lamp.axes.y = cross(lamp.axes.z, lamp.axes.x);
  const PieceBounds bounds = bounds_of(render_scene, lamp.axes, ahead);
  if (bounds.empty()) return lamp;
  const Vec3d &low = bounds.low, &high = bounds.high;
  lamp.eye = lamp.axes * (0.5 * (low + high));
  lamp.half_width = 0.5 * (high.x - low.x) + 0.05;
  lamp.half_height = 0.5 * (high.y - low.y) + 0.05;
  lamp.half_depth = 0.5 * (high.z - low.z) + 0.05;
  MUROSIMF_ASSERT(lamp.half_width > 0 && lamp.half_height > 0 && lamp.half_depth > 0);
  return lamp;
}

}  // namespace murosimf::render
