/// scene_message.h - the appearance of a scene, as one foxglove.SceneUpdate: primitives and triangles on the frames of links.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "murosimf/recording/recorded_frame.h"
#include "murosimf/scene/scene.h"

namespace murosimf::recording {

/// For an initialized scene. Unreadable meshes are left out, as in pictures.

class SceneLooks {
 public:
  SceneLooks(const scene::Scene& scene, const std::vector<RecordedEntity>& entities);

  /// foxglove.SceneUpdate for this instant. Entities absent in `present`, or behind its end, are deleted.
  [[nodiscard]] std::string message(Duration time, const std::vector<char>& present) const;

 private:
  struct Part {
    int entity = -1;       // index of the RecordedEntity; -1: static
    std::string id;        // of the SceneEntity
    std::string frame;     // that it is attached to
    std::string contents;  // its fields except time, frame, id
  };
  std::vector<Part> parts_;
};

/// foxglove.SceneUpdate of arrows: the force of each contact, 1 m long for 500 N.
[[nodiscard]] std::string force_arrows(Duration time, const std::vector<ContactMark>& contacts);

}  // namespace murosimf::recording
