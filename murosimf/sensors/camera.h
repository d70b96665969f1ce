/// camera.h - sensor: a camera with a real lens (paper 6.2).
///
/// Axes of the sensor: x forward along the optical axis, y to the left, z up. A frame (frame.h) is exposed from the
/// instant of its sample on. Row v of h rows is exposed from t_v = t + readout_time v / h to t_v + exposure_time; rows are
/// exposed in readout_bands groups, each at the time of its middle, and an exposure is the mean (of light, not of sRGB)
/// of motion_samples views at even times. Within a frame everything moves on with the velocities of the sample.
///
/// What becomes of the light, in this order: distortion of the lens, Gaussian blur, exposure, noise of the sensor, Bayer
/// mosaic (gaussian_blur.h, light.h, image_noise.h, bayer.h).
///
/// Outputs, all of them true: `position` [m] and `orientation` (quaternion w x y z, axes of the sensor) in the world at
/// the sample; `intrinsics` fx fy cx cy [px]; `mounting_error` roll pitch yaw [rad].
/// Source: rolling shutter as rows of one moving camera: Meingast, Geyer, Sastry, "Geometric models of rolling-shutter
/// cameras", OMNIVIS 2005.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "murosimf/sensors/camera_frame.h"
#include "murosimf/sensors/camera_model.h"
#include "murosimf/sensors/mounting.h"
#include "murosimf/sensors/sensor.h"

namespace murosimf::sensors {

class Camera final : public Sensor {
 public:
  /// Throws SetupError that names the number that is impossible.
  Camera(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings);

  [[nodiscard]] std::string diagnostic(const LevelTraits& level) const override;

  void entity_added(Setup& setup) override;
  void entity_taken_back(const Entity& entity) noexcept override;

 private:
  void measure(std::span<double> values) noexcept override;
  void start() override;
  void heed();
  void open();
  void memory(StateArchive& archive) override;
  void draw_anew(std::uint64_t seed) override { eye_.reseed(seed); }
  void taken(std::uint64_t sample) noexcept override;
  void arrived(std::uint64_t sample) noexcept override;

  CameraModel eye_;
  Vec3d mounting_error_;
  Mounting mounting_;
  std::function<ViewSource*()> find_source_;
  CameraFrame& frame_;
  ViewSource* source_ = nullptr;                             // none: it draws nothing
  bool started_ = false, wanted_ = false, offered_ = false;  // at a reset its frame is as when it was attached
  std::vector<CameraPicture> on_the_way_;
  std::shared_ptr<const std::string> fold_warning_;  // empty: the lens is fine
  imaging::ColorImage colors_behind_;                // a mosaic's; memory that pictures take turns in
};

}  // namespace murosimf::sensors
