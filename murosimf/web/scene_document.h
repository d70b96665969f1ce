/// scene_document.h - appearance and names of a scene, as one binary message for the page: sent once, followed by poses.
///
///     u32 length of the JSON text, the text, zeros up to a multiple of 4, then numbers referenced by the text [little-endian]
///
/// docs/web.md has the keys. The appearance is that of cameras and pictures (appearance/, render/).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "murosimf/scene/scene.h"

namespace murosimf::web {

/// A visible moving entity: its row in messages of poses (pose_message.h).
struct ShownEntity {
  std::size_t index = 0;  ///< in the world
  std::vector<int>
      objects;  ///< objects of the model with poses in messages: the base first, then links with visible parts
};

struct SceneDocument {
  std::string bytes;
  std::vector<ShownEntity> moving;
  std::size_t entities = 0;  ///< number in the world when it was created
};

/// For an initialized scene, between two steps. Unreadable meshes are left out, as in pictures.
[[nodiscard]] SceneDocument scene_document(const scene::Scene& scene);

}  // namespace murosimf::web
