/// gl_strokes.h - strokes painted on the ground as rectangles, with a margin for the filter of shaders.cpp.
///
/// Only for the .cpp files of this folder: it brings OpenGL in.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "murosimf/render/opengl/gl_attributes.h"
#include "murosimf/render/opengl/gl_handles.h"
#include "murosimf/render/stroke_pieces.h"

namespace murosimf::render {

/// A corner of the rectangle around one straight piece of a stroke (shaders.cpp).
struct StrokeCorner {
  std::array<float, 4> ends, size;
  std::array<float, 3> corner;
};

struct StrokeBuffers {
  void fill(const Markings& markings) {
    std::vector<StrokeCorner> corners;
    for (const StrokePiece& piece : stroke_pieces(markings)) add(piece, corners);
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
  static void add(const StrokePiece& piece, std::vector<StrokeCorner>& corners) {
    const auto number = [](double x) { return static_cast<float>(x); };
    const auto flag = [](bool is) { return is ? 1.0F : 0.0F; };
    const StrokePiece::End &a = piece.begin, &b = piece.end;
    for (const auto& [side, at] :
         {std::array<float, 2>{-1, 0}, std::array<float, 2>{-1, 1}, std::array<float, 2>{1, 1},
          std::array<float, 2>{-1, 0}, std::array<float, 2>{1, 1}, std::array<float, 2>{1, 0}}) {
      corners.push_back({{number(a.x), number(a.y), number(b.x), number(b.y)},
                         {number(piece.half_width), number(a.beyond), number(b.beyond), flag(a.soft)},
                         {side, at, flag(b.soft)}});
    }
  }
};

}  // namespace murosimf::render
