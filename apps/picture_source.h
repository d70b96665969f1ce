/// picture_source.h - sources of the pictures of `murosimf render`: a viewpoint by name, or a camera of a robot.
#pragma once

#include <memory>
#include <optional>
#include <variant>

#include "apps/camera_feed.h"
#include "apps/render_options.h"
#include "murosimf/recording/recorded_run.h"
#include "murosimf/scene/scene.h"
#include "murosimf/sensors/camera_frame.h"

namespace murosimf::app {

/// A picture: colors, or numbers of 16 bits: depths [mm] or labels.
using Taken = std::variant<imaging::ColorImage, imaging::NumberImage>;

/// Of --layer: whether pictures have numbers, and whether these are labels. Throws SetupError if there is no such layer.
[[nodiscard]] bool has_numbers(const RenderOptions& options);
[[nodiscard]] bool has_labels(const RenderOptions& options);

/// Where pictures come from.
class PictureSource {
 public:
  virtual ~PictureSource() = default;
  /// Pictures per second of a video, and per second of simulated time.
  [[nodiscard]] virtual double fps() const = 0;
  [[nodiscard]] virtual double rate() const = 0;
  /// The picture of an instant that has come, or the first one after it; the simulation may go on for that. Nothing if it
  /// was interrupted.
  virtual std::optional<Taken> take(Duration instant) = 0;
};

/// A camera that a robot carries; before the scene is initialized. Throws SetupError if there is none, or nothing can be
/// drawn here.
[[nodiscard]] std::unique_ptr<PictureSource> make_robot_camera(scene::Scene& scene, const RenderOptions& options);

/// A viewpoint outside of the robots; after the scene is initialized. `run`: whose scene it is, which has what other programs drew then; null:
/// none. `inset`: whose last frame is in a corner; null: none. Throws SetupError.
[[nodiscard]] std::unique_ptr<PictureSource> make_eye(scene::Scene& scene, const RenderOptions& options,
                                                      const std::shared_ptr<const recording::RecordedRun>& run,
                                                      std::unique_ptr<CameraFeed> inset);

}  // namespace murosimf::app
