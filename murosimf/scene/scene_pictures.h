/// scene_pictures.h - pictures of a scene for people: from above with everybody's path, and by a renderer.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "murosimf/scene/scene.h"

namespace murosimf::render {
class Renderer;
}

namespace murosimf::scene {

/// Draws the field from above with everybody's path so far (without SceneOptions::paths: only where they are now). Throws
/// SetupError if the file cannot be written.
void write_picture(const Scene& scene, const std::filesystem::path& file);

/// A renderer for who looks from outside (murosimf render), in this light. The scene must be initialized and outlive it. Throws
/// SetupError if this machine or this build cannot draw.
[[nodiscard]] std::unique_ptr<render::Renderer> make_renderer(Scene& scene, const scene_file::LightSpec& light);

/// A renderer that keeps up with what changes in a scene: its light, its ball, who is there.
class ScenePainter {
 public:
  using ForPeople = std::function<void(scene_file::LightSpec&)>;
  using Prepare = std::function<void(render::Renderer&)>;

  /// `for_people` makes the scene's light fit for who looks; `prepare`, if given, is called with every new renderer. As make_renderer().
  explicit ScenePainter(Scene& scene, ForPeople for_people, Prepare prepare = {});
  ~ScenePainter();
  ScenePainter(const ScenePainter&) = delete;
  ScenePainter& operator=(const ScenePainter&) = delete;

  /// For pictures of this instant. Throws SetupError.
  [[nodiscard]] render::Renderer& renderer();

 private:
  Scene& scene_;
  ForPeople for_people_;
  Prepare prepare_;
  int changes_seen_ = 0;
  std::unique_ptr<render::Renderer> renderer_;
};

}  // namespace murosimf::scene
