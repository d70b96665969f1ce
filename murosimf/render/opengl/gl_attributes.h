/// gl_attributes.h - buffers of corners, and the layout of their attributes for a shader.
///
/// Only for the .cpp files of this folder: it brings OpenGL in.
#pragma once

#include <cstddef>
#include <vector>

#include <epoxy/gl.h>

#include "murosimf/math/assert.h"

namespace murosimf::render {

/// Describes the attribute `index` of the buffer that is bound: `numbers` of a type at `offset` of every `stride`
/// bytes. Unsigned integers remain integers.
inline void attribute(GLuint index, GLint numbers, GLenum type, std::size_t stride, std::size_t offset,
                      bool per_instance, bool normalized = false) {
  MUROSIMF_ASSERT(numbers >= 1 && numbers <= 4 && stride > 0);
  const void* place = reinterpret_cast<const void*>(offset);
  glEnableVertexAttribArray(index);
  if (type == GL_UNSIGNED_INT) {
    glVertexAttribIPointer(index, numbers, type, static_cast<GLsizei>(stride), place);
  } else {
    glVertexAttribPointer(index, numbers, type, normalized ? GL_TRUE : GL_FALSE, static_cast<GLsizei>(stride), place);
  }
  glVertexAttribDivisor(index, per_instance ? 1 : 0);
}

/// Fills a buffer, and binds it.
template <class T>
void upload(GLenum kind, GLuint buffer, const std::vector<T>& data, GLenum use) {
  glBindBuffer(kind, buffer);
  glBufferData(kind, static_cast<GLsizeiptr>(data.size() * sizeof(T)), data.data(), use);
}

}  // namespace murosimf::render
