/// gl_scenery.h - what is only looked at, in the graphics device's memory: walls, nets, sky, contact shadows and the pile of carpets.
///
/// Only for the .cpp files of this folder: it brings OpenGL in.
#pragma once

#include <vector>

#include "murosimf/render/look.h"
#include "murosimf/render/opengl/gl_attributes.h"
#include "murosimf/render/opengl/gl_handles.h"

namespace murosimf::render {

struct SurfaceBuffers {
  void fill(const LookSurface& surface) {
    count = static_cast<GLsizei>(surface.triangles.size());
    glBindVertexArray(*array);
    upload(GL_ELEMENT_ARRAY_BUFFER, *indices, surface.triangles, GL_STATIC_DRAW);
    upload(GL_ARRAY_BUFFER, *corners, surface.corners, GL_STATIC_DRAW);
    attribute(0, 3, GL_FLOAT, sizeof(LookCorner), offsetof(LookCorner, place), false);
    attribute(1, 2, GL_FLOAT, sizeof(LookCorner), offsetof(LookCorner, at), false);
  }
  void draw() {
    glBindVertexArray(*array);
    glDrawElements(GL_TRIANGLES, count, GL_UNSIGNED_INT, nullptr);
  }

  GLsizei count = 0;
  GlVertexArray array;
  GlBuffer corners, indices;
};

/// A triangle over the whole picture.
struct WholePicture {
  void draw() {
    if (!filled) {
      glBindVertexArray(*array);
      upload(GL_ARRAY_BUFFER, *corners, std::vector<float>{-1, -1, 3, -1, -1, 3}, GL_STATIC_DRAW);
      attribute(0, 2, GL_FLOAT, 2 * sizeof(float), 0, false);
      filled = true;
    }
    glBindVertexArray(*array);
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }

  bool filled = false;
  GlVertexArray array;
  GlBuffer corners;
};

/// A corner of a contact shadow (shaders.cpp).
struct ContactCorner {
  std::array<float, 3> place;
  std::array<float, 2> where;
  std::array<float, 4> size;
};

struct ContactBuffers {
  void draw(const std::vector<ContactCorner>& shadows) {
    glBindVertexArray(*array);
    upload(GL_ARRAY_BUFFER, *corners, shadows, GL_STREAM_DRAW);
    attribute(0, 3, GL_FLOAT, sizeof(ContactCorner), offsetof(ContactCorner, place), false);
    attribute(1, 2, GL_FLOAT, sizeof(ContactCorner), offsetof(ContactCorner, where), false);
    attribute(2, 4, GL_FLOAT, sizeof(ContactCorner), offsetof(ContactCorner, size), false);
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(shadows.size()));
  }

  GlVertexArray array;
  GlBuffer corners;
};

/// Fills a texture with the pile, in all sizes, and binds it.
inline void fill_pile(GLuint texture) {
  glBindTexture(GL_TEXTURE_2D, texture);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, pile_side, pile_side, 0, GL_RED, GL_UNSIGNED_BYTE, pile().data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glGenerateMipmap(GL_TEXTURE_2D);
}

}  // namespace murosimf::render
