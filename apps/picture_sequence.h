/// picture_sequence.h - numbered pictures of a scene while it runs.
#pragma once

#include <filesystem>
#include <memory>

#include "murosimf/scene/scene.h"
#include "murosimf/scene/scene_pictures.h"

namespace murosimf::app {

class PictureSequence {
 public:
  /// Makes the folder if it is not there. `every` [s] of simulated time. Throws SetupError if the folder cannot be
  /// written to, or if `every` is no time.
  PictureSequence(std::filesystem::path folder, double every);

  /// To be called once, when the scene's simulation is initialized. Throws SetupError if pictures cannot be drawn here.
  void show(scene::Scene& scene);

  /// Simulated time of the next picture.
  [[nodiscard]] Duration next() const { return next_; }
  /// Writes it: 0000.png, 0001.png, ...
  void take();

 private:
  [[nodiscard]] std::filesystem::path file() const;

  std::filesystem::path folder_;
  Duration every_, next_{};
  int count_ = 0;
  const scene::Scene* scene_ = nullptr;
  std::unique_ptr<scene::ScenePainter> painter_;
};

}  // namespace murosimf::app
