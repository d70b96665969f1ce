#include "murosimf/render/opengl/gl_handles.h"

#include <array>
#include <string>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::render {
namespace {

constexpr std::string_view version = "#version 330 core\n";

void check(GLint good, std::string_view message) {
  if (good == GL_FALSE) throw SetupError(fmt::format("the OpenGL driver refuses a shader: {}", message));
}

GLuint compiled(GLenum kind, std::initializer_list<std::string_view> parts) {
  std::string source(version);
  for (const std::string_view part : parts) source += part;
  const GLuint shader = glCreateShader(kind);
  MUROSIMF_ASSERT(shader != 0);
  const GLchar* text_begin = source.c_str();
  glShaderSource(shader, 1, &text_begin, nullptr);
  glCompileShader(shader);
  GLint good = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
  std::array<char, 1024> text{};
  glGetShaderInfoLog(shader, static_cast<GLsizei>(text.size()), nullptr, text.data());
  check(good, text.data());
  return shader;
}

}  // namespace

GlProgram::GlProgram(std::initializer_list<std::string_view> vertex, std::initializer_list<std::string_view> fragment) {
  const GLuint name = *name_;
  for (const GLuint shader : {compiled(GL_VERTEX_SHADER, vertex), compiled(GL_FRAGMENT_SHADER, fragment)}) {
    glAttachShader(name, shader);
    glDeleteShader(shader);  // marks it: the driver deletes it with the program
  }
  glLinkProgram(name);
  GLint good = GL_FALSE;
  glGetProgramiv(name, GL_LINK_STATUS, &good);
  std::array<char, 1024> text{};
  glGetProgramInfoLog(name, static_cast<GLsizei>(text.size()), nullptr, text.data());
  check(good, text.data());
}

}  // namespace murosimf::render
