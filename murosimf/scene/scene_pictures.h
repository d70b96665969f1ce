/// scene_pictures.h - pictures of a scene: from above with the paths of its entities, and by a renderer.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "murosimf/scene/scene.h"

namespace murosimf::render {
class Renderer;
}

namespace murosimf::scene {

/// Draws the field from above with the paths of all entities so far (without SceneOptions::paths: only their present places). Throws
/// SetupError if the file cannot be written.
void write_picture(const Scene& scene, const std::filesystem::path& file);

/// A renderer for observers (murosimf render), in this light. The scene must be initialized and outlive it. Throws
/// SetupError if this machine or this build cannot draw.
[[nodiscard]] std::unique_ptr<render::Renderer> make_renderer(Scene& scene, const scene_file::LightSpec& light);

/// A renderer that follows changes of a scene: its light, its ball, its entities.
class ScenePainter {
 public:
  using ForPeople = std::function<void(scene_file::LightSpec&)>;
  using Prepare = std::function<void(render::Renderer&)>;

  /// `for_people` adapts the scene's light for observers; `prepare`, if given, is called with every new renderer. As make_renderer().
  explicit ScenePainter(Scene& scene, ForPeople for_people, Prepare prepare = {});
  ~ScenePainter();
  ScenePainter(const ScenePainter&) = delete;
  ScenePainter& operator=(const ScenePainter&) = delete;

  /// For pictures of the present instant. Throws SetupError.
  [[nodiscard]] render::Renderer& renderer();

 private:
  Scene& scene_;
  ForPeople for_people_;
  Prepare prepare_;
  int changes_seen_ = 0;
  std::unique_ptr<render::Renderer> renderer_;
};

}  // namespace murosimf::scene
