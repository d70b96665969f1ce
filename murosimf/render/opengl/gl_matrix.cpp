#include "murosimf/render/opengl/gl_matrix.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "murosimf/math/assert.h"

namespace murosimf::render {
namespace {

GlMatrix by_rows(std::initializer_list<double> numbers) {
  MUROSIMF_ASSERT(numbers.size() == 16);
  GlMatrix m{};
  std::size_t i = 0;
  for (const double number : numbers) {
    // Given by rows as on paper; OpenGL stores columns.
    m[i % 4 * 4 + i / 4] = static_cast<float>(number);
    ++i;
  }
  return m;
}

struct Bounds {
  Vec3d low{1e9, 1e9, 1e9}, high{-1e9, -1e9, -1e9};
  [[nodiscard]] bool empty() const { return low.x > high.x; }
};

/// [m] Bounds of all pieces, along `axes`.
Bounds bounds_of(const RenderScene& render_scene, const Mat3d& axes, double ahead) {
  Bounds bounds;
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

}  // namespace

/// Sums in double precision: positions are far from the origin in relation to their differences.
GlMatrix operator*(const GlMatrix& a, const GlMatrix& b) {
  GlMatrix product{};
  for (std::size_t column = 0; column < 4; ++column) {
    for (std::size_t row = 0; row < 4; ++row) {
      double sum = 0;
      for (std::size_t k = 0; k < 4; ++k) sum += double{a[4 * k + row]} * double{b[4 * column + k]};
      product[4 * column + row] = static_cast<float>(sum);
    }
  }
  return product;
}

GlMatrix matrix_of(const Mat3d& R, const Vec3d& r) {
  return by_rows({R.x.x, R.y.x, R.z.x, r.x,  //
                  R.x.y, R.y.y, R.z.y, r.y,  //
                  R.x.z, R.y.z, R.z.z, r.z,  //
                  0, 0, 0, 1});
}

GlMatrix half_and_half() {
  return by_rows({0.5, 0, 0, 0.5,  //
                  0, 0.5, 0, 0.5,  //
                  0, 0, 0.5, 0.5,  //
                  0, 0, 0, 1});
}

GlMatrix clip_of(const sensors::Perspective& view, double nearest) {
  const double width = view.right - view.left, height = view.bottom - view.top;
  MUROSIMF_ASSERT(width > 0 && height > 0 && nearest > 0);
  // The limit of the usual matrix for a farthest plane at infinity: nothing is cut far away.
  return by_rows({2 / width, 0, -(view.right + view.left) / width, 0,    //
                  0, 2 / height, -(view.bottom + view.top) / height, 0,  //
                  0, 0, 1, -2 * nearest,                                 //
                  0, 0, 1, 0});
}

GlMatrix parallel_clip_of(const sensors::Perspective& window, const RenderScene& render_scene, double ahead) {
  constexpr double room = 0.05;  // [m]
  const double width = window.right - window.left, height = window.bottom - window.top;
  const Bounds bounds = bounds_of(render_scene, window.axes, ahead);
  const double at = dot(window.axes.z, window.eye);
  const double nearest = bounds.empty() ? -room : bounds.low.z - at - room;
  const double farthest = bounds.empty() ? room : bounds.high.z - at + room, depth = farthest - nearest;
  MUROSIMF_ASSERT(width > 0 && height > 0 && depth > 0);
  return by_rows({2 / width, 0, 0, -(window.right + window.left) / width,    //
                  0, 2 / height, 0, -(window.bottom + window.top) / height,  //
                  0, 0, 2 / depth, -(farthest + nearest) / depth,            //
                  0, 0, 0, 1});
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
  const Bounds bounds = bounds_of(render_scene, lamp.axes, ahead);
  if (bounds.empty()) return lamp;
  const Vec3d &low = bounds.low, &high = bounds.high;
  lamp.eye = lamp.axes * (0.5 * (low + high));
  lamp.half_width = 0.5 * (high.x - low.x) + 0.05;
  lamp.half_height = 0.5 * (high.y - low.y) + 0.05;
  lamp.half_depth = 0.5 * (high.z - low.z) + 0.05;
  MUROSIMF_ASSERT(lamp.half_width > 0 && lamp.half_height > 0 && lamp.half_depth > 0);
  return lamp;
}

GlMatrix clip_of(const LampView& lamp) {
  return by_rows({1 / lamp.half_width, 0, 0, 0,   //
                  0, 1 / lamp.half_height, 0, 0,  //
                  0, 0, 1 / lamp.half_depth, 0,   //
                  0, 0, 0, 1});
}

}  // namespace murosimf::render
