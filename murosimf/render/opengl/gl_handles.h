/// gl_handles.h - OpenGL's names of objects, deleted with their owner. The context must be current for all of it.
///
/// Only for the .cpp files of this folder: it brings OpenGL in.
#pragma once

#include <initializer_list>
#include <string_view>
#include <utility>

#include <epoxy/gl.h>

#include "murosimf/math/assert.h"

namespace murosimf::render {

/// Owns one name; `Kind` creates and deletes it.
template <class Kind>
class GlHandle {
 public:
  GlHandle() = default;
  ~GlHandle() { reset(); }
  GlHandle(GlHandle&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  GlHandle& operator=(GlHandle&& other) noexcept {
    if (this != &other) reset(std::exchange(other.name_, 0));
    return *this;
  }
  /// The name; made on first use.
  GLuint operator*() {
    if (name_ == 0) name_ = Kind::make();
    MUROSIMF_ASSERT(name_ != 0);
    return name_;
  }

 private:
  void reset(GLuint name = 0) {
    if (name_ != 0) Kind::remove(name_);
    name_ = name;
  }
  GLuint name_ = 0;
};

// clang-format off
struct BufferKind {
  static GLuint make() { GLuint name = 0; glGenBuffers(1, &name); return name; }
  static void remove(GLuint name) { glDeleteBuffers(1, &name); }
};
struct VertexArrayKind {
  static GLuint make() { GLuint name = 0; glGenVertexArrays(1, &name); return name; }
  static void remove(GLuint name) { glDeleteVertexArrays(1, &name); }
};
struct TextureKind {
  static GLuint make() { GLuint name = 0; glGenTextures(1, &name); return name; }
  static void remove(GLuint name) { glDeleteTextures(1, &name); }
};
struct RenderbufferKind {
  static GLuint make() { GLuint name = 0; glGenRenderbuffers(1, &name); return name; }
  static void remove(GLuint name) { glDeleteRenderbuffers(1, &name); }
};
struct FramebufferKind {
  static GLuint make() { GLuint name = 0; glGenFramebuffers(1, &name); return name; }
  static void remove(GLuint name) { glDeleteFramebuffers(1, &name); }
};
struct ProgramKind {
  static GLuint make() { return glCreateProgram(); }
  static void remove(GLuint name) { glDeleteProgram(name); }
};
// clang-format on

using GlBuffer = GlHandle<BufferKind>;
using GlVertexArray = GlHandle<VertexArrayKind>;
using GlTexture = GlHandle<TextureKind>;
using GlRenderbuffer = GlHandle<RenderbufferKind>;
using GlFramebuffer = GlHandle<FramebufferKind>;

/// A vertex shader and a fragment shader.
class GlProgram {
 public:
  /// Compiles and links. Throws SetupError with the driver's message. The parts of a shader are concatenated.
  GlProgram(std::initializer_list<std::string_view> vertex, std::initializer_list<std::string_view> fragment);
  void use() { glUseProgram(*name_); }
  [[nodiscard]] GLint uniform(const char* name) { return glGetUniformLocation(*name_, name); }

 private:
  GlHandle<ProgramKind> name_;
};

}  // namespace murosimf::render
