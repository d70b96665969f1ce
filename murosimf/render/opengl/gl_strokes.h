/// gl_strokes.h - strokes painted on the ground as rectangles, with a margin for the filter of shaders.cpp.
///
/// Only for the .cpp files of this folder: it brings OpenGL in.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "murosimf/math/assert.h"
#include "murosimf/math/scalar.h"
#include "murosimf/model/shape.h"
#include "murosimf/render/opengl/gl_attributes.h"
#include "murosimf/render/opengl/gl_handles.h"

namespace murosimf::render {

/// A corner of the rectangle around one straight piece of a stroke (shaders.cpp).
struct StrokeCorner {
  std::array<float, 4> ends, size;
  std::array<float, 3> corner;
};

struct StrokeBuffers {
  void fill(const Markings& markings) {
    std::vector<StrokeCorner> corners;
    for (const Stroke& stroke : markings.strokes) add(stroke, corners);
    count = static_cast<GLsizei>(corners.size());
    glBindVertexArray(*array);
    upload(GL_ARRAY_BUFFER, *buffer, corners, GL_STATIC_DRAW);
    attribute(0, 4, GL_FLOAT, sizeof(StrokeCorner), offsetof(StrokeCorner, ends), false);
    attribute(1, 4, GL_FLOAT, sizeof(StrokeCorner), offsetof(StrokeCorner, size), false);
    attribute(2, 3, GL_FLOAT, sizeof(StrokeCorner), offsetof(StrokeCorner, corner), false);
  }

  GLsizei count = 0;
  GlVertexArray array;
  GlBuffer buffer;

 private:
  /// The end of a straight piece where another one begins.
  struct Joint {
    float beyond = 0;   // [m] by which it is extended, so that the outer corner is filled
    bool soft = false;  // the next one continues in about the same direction: no edge between them
  };

  static Joint joint(const Vec3d& before, const Vec3d& at, const Vec3d& after, double half_width) {
    const Vec3d a = at - before, b = after - at;
    const double turn = std::abs(std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y));
    // The miter of a bend; beyond a right angle the tangent grows without bound.
    return {static_cast<float>(half_width * std::tan(std::min(0.5 * turn, 0.25 * pi))), turn < 0.5};
  }

  static void add(const Stroke& stroke, std::vector<StrokeCorner>& corners) {
    const auto& p = stroke.points;
    const double half = 0.5 * stroke.width;
    MUROSIMF_ASSERT(half >= 0);
    const std::size_t last = p.size() - 1;
    const bool closed = p.size() > 2 && norm(p.front() - p.back()) < 1e-9;
    for (std::size_t i = 0; i < last; ++i) {
      Joint begin, end;
      if (i > 0 || closed) begin = joint(p[i > 0 ? i - 1 : last - 1], p[i], p[i + 1], half);
      if (i + 1 < last || closed) end = joint(p[i], p[i + 1], p[i + 1 < last ? i + 2 : 1], half);
      const std::array<float, 2> a{static_cast<float>(p[i].x), static_cast<float>(p[i].y)};
      const std::array<float, 2> b{static_cast<float>(p[i + 1].x), static_cast<float>(p[i + 1].y)};
      if (a == b) continue;
      const auto corner = [&](float side, float at) {
        corners.push_back({{a[0], a[1], b[0], b[1]},
                           {static_cast<float>(half), begin.beyond, end.beyond, begin.soft ? 1.0F : 0.0F},
                           {side, at, end.soft ? 1.0F : 0.0F}});
      };
      for (const auto& [side, at] :
           {std::array<float, 2>{-1, 0}, std::array<float, 2>{-1, 1}, std::array<float, 2>{1, 1},
            std::array<float, 2>{-1, 0}, std::array<float, 2>{1, 1}, std::array<float, 2>{1, 0}}) {
        corner(side, at);
      }
    }
  }
};

}  // namespace murosimf::render
