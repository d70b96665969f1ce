#include "murosimf/render/projection.h"

#include <algorithm>
#include <cmath>

#include "murosimf/math/assert.h"

namespace murosimf::render {

Mat3d axes_from(double azimuth, double elevation) {
  const Vec3d right{-std::sin(azimuth), std::cos(azimuth), 0};
  const Vec3d toward{std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                     std::sin(elevation)};
  return {right, cross(right, toward), -toward};
}

ParallelView view_of(std::span<const Vec3d> points, const Mat3d& axes, int width, int height) {
  constexpr double room = 1 - 2 * 0.06;  // [1] of the picture, inside the margins
  constexpr double least = 1e-3;         // [m] of the visible area
  ParallelView view{.center = {}, .axes = axes, .width = width, .height = height};
  if (points.empty()) return view;
  Vec3d low = transposed_times(axes, points[0]), high = low;
  for (const Vec3d& point : points) {
    const Vec3d p = transposed_times(axes, point);
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const Vec3d size = high - low;
  view.center = axes * (0.5 * (low + high));
  MUROSIMF_ASSERT(width > 0 && height > 0);
  view.pixel = std::max(std::max(size.x, least) / (room * width), std::max(size.y, least) / (room * height));
  return view;
}

Projection::Projection(const ParallelView& view) : parallel(true) {
  MUROSIMF_ASSERT(view.pixel > 0);
  window.eye = view.center;
  window.axes = view.axes;
  window.right = 0.5 * view.width * view.pixel;
  window.left = -window.right;
  window.bottom = 0.5 * view.height * view.pixel;
  window.top = -window.bottom;
  window.width = view.width;
  window.height = view.height;
}

}  // namespace murosimf::render
