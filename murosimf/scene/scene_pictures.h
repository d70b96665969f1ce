/// scene_pictures.h - pictures of a scene for people: from above with everybody's path, and by a renderer.
#pragma once

#include <filesystem>
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

}  // namespace murosimf::scene
