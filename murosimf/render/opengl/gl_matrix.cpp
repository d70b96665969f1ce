#include "murosimf/render/opengl/gl_matrix.h"

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
  const PieceBounds bounds = bounds_of(render_scene, window.axes, ahead);
  const double at = dot(window.axes.z, window.eye);
  const double nearest = bounds.empty() ? -room : bounds.low.z - at - room;
  const double farthest = bounds.empty() ? room : bounds.high.z - at + room, depth = farthest - nearest;
  MUROSIMF_ASSERT(width > 0 && height > 0 && depth > 0);
  return by_rows({2 / width, 0, 0, -(window.right + window.left) / width,    //
                  0, 2 / height, 0, -(window.bottom + window.top) / height,  //
                  0, 0, 2 / depth, -(farthest + nearest) / depth,            //
                  0, 0, 0, 1});
}

GlMatrix clip_of(const LampView& lamp) {
  return by_rows({1 / lamp.half_width, 0, 0, 0,   //
                  0, 1 / lamp.half_height, 0, 0,  //
                  0, 0, 1 / lamp.half_depth, 0,   //
                  0, 0, 0, 1});
}

}  // namespace murosimf::render
