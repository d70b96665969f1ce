/// gl_uniforms.h - numbers for programs.
///
/// Only for the .cpp files of this folder: it brings OpenGL in.
#pragma once

#include <array>
#include <span>

#include "murosimf/math/assert.h"
#include "murosimf/render/look.h"
#include "murosimf/render/opengl/gl_handles.h"
#include "murosimf/render/opengl/gl_matrix.h"

namespace murosimf::render {

using Float3 = std::array<float, 3>;

[[nodiscard]] inline Float3 floats(const Vec3d& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}
[[nodiscard]] inline Float3 floats(const Color& c) {
  return {static_cast<float>(c.red), static_cast<float>(c.green), static_cast<float>(c.blue)};
}

inline void set(GlProgram& program, const char* name, const Float3& v) {
  glUniform3fv(program.uniform(name), 1, v.data());
}
inline void set(GlProgram& program, const char* name, double v) {
  glUniform1f(program.uniform(name), static_cast<float>(v));
}
inline void set(GlProgram& program, const char* name, const GlMatrix& m) {
  glUniformMatrix4fv(program.uniform(name), 1, GL_FALSE, m.data());
}

/// Numbers of the patterns, for the program that is in use.
inline void set(GlProgram& program, std::span<const LookNumber> numbers) {
  for (const LookNumber& number : numbers) {
    std::array<float, 4> values{};
    MUROSIMF_ASSERT(!number.values.empty() && number.values.size() <= values.size());
    for (std::size_t i = 0; i < number.values.size(); ++i) values[i] = static_cast<float>(number.values[i]);
    const GLint at = program.uniform(number.name);
    switch (number.values.size()) {
      case 1: glUniform1fv(at, 1, values.data()); break;
      case 2: glUniform2fv(at, 1, values.data()); break;
      case 3: glUniform3fv(at, 1, values.data()); break;
      default: glUniform4fv(at, 1, values.data()); break;
    }
  }
}

}  // namespace murosimf::render
