/// gl_shadow_map.h - depths seen from a lamp: the reach of its light.
///
/// Only for the .cpp files of this folder: it brings OpenGL in.
#pragma once

#include <array>
#include <cstring>
#include <span>
#include <utility>
#include <vector>

#include "murosimf/render/instances.h"
#include "murosimf/render/opengl/gl_handles.h"
#include "murosimf/render/opengl/gl_matrix.h"

namespace murosimf::render {

struct ShadowMap {
  explicit ShadowMap(int pixels) : side(pixels) {
    glBindTexture(GL_TEXTURE_2D, *texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, side, side, 0, GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
    constexpr std::array<GLfloat, 4> lit{1, 1, 1, 1};
    glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, lit.data());
    for (const auto& [key, value] : {std::pair<GLenum, GLint>{GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER},
                                     {GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER},
                                     {GL_TEXTURE_MIN_FILTER, GL_LINEAR},
                                     {GL_TEXTURE_MAG_FILTER, GL_LINEAR},
                                     {GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE},
                                     {GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL}}) {
      glTexParameteri(GL_TEXTURE_2D, key, value);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, *frame);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, *texture, 0);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
  }

  /// Remembers these pieces. Returns whether the map has their shadows already: views of one instant share it.
  [[nodiscard]] bool remember(std::span<const Instance> pieces, const GlMatrix& from_lamp) {
    const bool same = from_lamp == clip && pieces.size() == drawn.size() &&
                      (drawn.empty() || std::memcmp(pieces.data(), drawn.data(), pieces.size_bytes()) == 0);
    if (!same) drawn.assign(pieces.begin(), pieces.end());
    clip = from_lamp;
    return same && is_drawn;
  }

  int side;  // [px]
  GlTexture texture;
  GlFramebuffer frame;
  GlMatrix to_lamp{}, clip{};
  double texel = 0;      // [m]
  double half_side = 1;  // [m]
  bool is_drawn = false;
  std::vector<Instance> drawn;
};

}  // namespace murosimf::render
