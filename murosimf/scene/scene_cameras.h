/// scene_cameras.h - renderers of a scene, for its cameras and for observers.
#pragma once

#include <memory>

#include "murosimf/sensors/view_source.h"

namespace murosimf::render {
struct Light;
class Renderer;
class SoftwareRenderer;
}  // namespace murosimf::render

namespace murosimf::scene_file {
struct LightSpec;
}

namespace murosimf::scene {

struct SceneParts;

/// The light of that name, with the changes of the scene.
[[nodiscard]] render::Light light_of(const scene_file::LightSpec& spec);

/// A renderer of the scene in this light. The scene must be initialized and outlive it. Throws SetupError if this machine
/// or this build cannot draw.
[[nodiscard]] std::unique_ptr<render::Renderer> make_renderer(SceneParts& parts, const scene_file::LightSpec& light);

/// What draws for cameras, in this light. The scene must be initialized and outlive it.
[[nodiscard]] std::unique_ptr<render::SoftwareRenderer> make_camera_renderer(SceneParts& parts,
                                                                             const scene_file::LightSpec& light);

/// Draws for the cameras of a scene, in its light, by the processor alone: the same bits on every machine. The renderer is created at the
/// first request.
class CameraRenderer final : public sensors::ViewSource {
 public:
  explicit CameraRenderer(SceneParts& parts);
  ~CameraRenderer() override;
  CameraRenderer(const CameraRenderer&) = delete;
  CameraRenderer& operator=(const CameraRenderer&) = delete;

  [[nodiscard]] sensors::ViewSource* view_source();
  /// Called between two steps when an entity was added to the scene, or changed its appearance.
  void renew();
  /// Called when the light has changed.
  void renew_light();

  void draw(const sensors::Perspective& perspective, const sensors::Layers& layers, double ahead,
            sensors::View& view) noexcept override;

 private:
  SceneParts& parts_;
  std::unique_ptr<render::SoftwareRenderer> renderer_;
};

}  // namespace murosimf::scene
