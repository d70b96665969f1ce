/// scene_cameras.h - who draws a scene for its cameras, and for people.
#pragma once

#include <memory>

#include "murosimf/sensors/view_source.h"

namespace murosimf::render {
class Renderer;
}

namespace murosimf::scene_file {
struct LightSpec;
}

namespace murosimf::scene {

struct SceneParts;

/// A renderer of the scene in this light. The scene must be initialized and outlive it. Throws SetupError if this machine
/// or this build cannot draw.
[[nodiscard]] std::unique_ptr<render::Renderer> make_renderer(SceneParts& parts, const scene_file::LightSpec& light);

/// Draws for the cameras of a scene, in its light. Its renderer is made when the first of them asks.
class CameraRenderer final : public sensors::ViewSource {
 public:
  explicit CameraRenderer(SceneParts& parts);
  ~CameraRenderer() override;
  CameraRenderer(const CameraRenderer&) = delete;
  CameraRenderer& operator=(const CameraRenderer&) = delete;

  /// Null if nobody can draw here, which is a warning then.
  [[nodiscard]] sensors::ViewSource* view_source();
  /// Somebody has been added to the scene, or looks different. Between two steps.
  void renew();
  /// The light is another one.
  void renew_light();

  void draw(const sensors::Perspective& perspective, const sensors::Layers& layers, double ahead,
            sensors::View& view) noexcept override;

 private:
  SceneParts& parts_;
  std::unique_ptr<render::Renderer> renderer_;
  bool cannot_draw_ = false;
};

}  // namespace murosimf::scene
