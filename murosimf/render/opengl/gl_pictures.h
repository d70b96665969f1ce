/// gl_pictures.h - pictures of surfaces in the graphics device's memory.
///
/// Only for the .cpp files of this folder: it brings OpenGL in.
#pragma once

#include <algorithm>
#include <map>

#include "murosimf/imaging/mip_picture.h"
#include "murosimf/render/instances.h"
#include "murosimf/render/opengl/gl_handles.h"

namespace murosimf::render {

class PictureTextures {
 public:
  /// Loads the pictures of all solids, each once.
  void fill(const MeshCatalog& catalog) {
    for (const RenderMesh& solid : catalog.meshes) {
      if (solid.picture && !textures_.contains(solid.picture.get())) load(*solid.picture);
    }
  }
  [[nodiscard]] bool empty() const { return textures_.empty(); }
  /// Binds one of them to the active unit.
  void bind(const imaging::MipPicture* picture) { glBindTexture(GL_TEXTURE_2D, *textures_.at(picture)); }

 private:
  /// All sizes that the device takes: the same means of light that the processor draws with.
  void load(const imaging::MipPicture& picture) {
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    glBindTexture(GL_TEXTURE_2D, *textures_[&picture]);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    GLint level = 0;
    for (const imaging::ColorImage& image : picture.levels) {
      if (std::max(image.width(), image.height()) > most) continue;
      glTexImage2D(GL_TEXTURE_2D, level++, GL_SRGB8, image.width(), image.height(), 0, GL_RGB, GL_UNSIGNED_BYTE,
                   image.pixels().data());
    }
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, level - 1);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
  }

  std::map<const imaging::MipPicture*, GlTexture> textures_;
};

}  // namespace murosimf::render
