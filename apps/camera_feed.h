/// camera_feed.h - frames of a camera that a robot carries, for pictures of `murosimf render`.
#pragma once

#include <string>
#include <string_view>

#include "murosimf/imaging/image.h"
#include "murosimf/model/error.h"
#include "murosimf/scene/scene.h"
#include "murosimf/sensors/camera_frame.h"

namespace murosimf::app {

class CameraFeed {
 public:
  /// Before the scene is initialized: the camera draws from then on. `option`: "--camera", for messages; `path`: ROBOT.CAMERA. Throws
  /// SetupError with the nearest name if there is no such camera.
  CameraFeed(scene::Scene& scene, std::string option, std::string path);

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] const sensors::CameraFrame& frame() const { return frame_; }
  /// Runs the simulation until there is a frame that was exposed at `instant` or later: one of now is there after the next step, or later by
  /// its delay. False: interrupted. Throws SetupError if none comes.
  [[nodiscard]] bool wait(Duration instant);

  /// "--set 'ROBOT.sensors.CAMERA.CHANGE'": what changes the camera, for messages.
  [[nodiscard]] std::string setting(std::string_view change) const;
  /// A layer of the frame. Throws SetupError, with what lets it, if the camera does not draw it.
  template <class Image>
  [[nodiscard]] const Image& wanted(const Image& image, std::string_view layer) const {
    if (!image.empty()) return image;
    refuse(layer);
  }
  /// The frame's colors, or its mosaic as gray. Throws SetupError if the camera draws neither.
  [[nodiscard]] imaging::ColorImage colors() const;

 private:
  [[noreturn]] void refuse(std::string_view layer) const;

  Simulation& simulation_;
  std::string option_, path_;
  const sensors::CameraFrame& frame_;
};

}  // namespace murosimf::app
