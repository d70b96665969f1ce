/// scene_document.h - what everything looks like and is called, as one binary message for the page: sent once, poses follow.
///
///     u32 length of the JSON text, the text, zeros up to a multiple of 4, then numbers that the text refers to [little-endian]
///
/// docs/web.md has the keys. Looks are those of cameras and pictures (appearance/, render/).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "murosimf/scene/scene.h"

namespace murosimf::web {

/// An entity that moves and can be seen: its row in messages of poses (pose_message.h).
struct ShownEntity {
  std::size_t index = 0;     ///< in the world
  std::vector<int> objects;  ///< of the model, whose poses are sent: links that carry something, and the base first
};

struct SceneDocument {
  std::string bytes;
  std::vector<ShownEntity> moving;
  std::size_t entities = 0;  ///< in the world, when it was made
};

/// Of a scene that is initialized, between two steps. Meshes that cannot be read are left out, as in pictures.
[[nodiscard]] SceneDocument scene_document(const scene::Scene& scene);

}  // namespace murosimf::web
