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

#include <memory>
#include <optional>
#include <vector>

#include "murosimf/imaging/bayer.h"
#include "murosimf/imaging/exposure.h"
#include "murosimf/imaging/gaussian_blur.h"
#include "murosimf/imaging/image_noise.h"
#include "murosimf/imaging/lens_map.h"
#include "murosimf/sensors/camera_frame.h"
#include "murosimf/sensors/camera_spec.h"
#include "murosimf/sensors/mounting.h"
#include "murosimf/sensors/sensor.h"

namespace murosimf::sensors {

/// Optical axes to those of a camera: x to the right is -y, y down is -z, z forward is x.
inline constexpr Mat3d optical_axes{{0, -1, 0}, {0, 0, -1}, {1, 0, 0}};

class Camera final : public Sensor {
 public:
  /// Throws SetupError that names the number that is impossible.
  Camera(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings);

  [[nodiscard]] std::string remark(const LevelTraits& level) const override;

  void entity_added(Setup& setup) override;
  void entity_taken_back(const Entity& entity) noexcept override;

 private:
  struct Picture {
    View view;
    imaging::GrayImage mosaic;
  };
  /// What was drawn for each view of the lens map.
  struct Windows {
    explicit Windows(std::span<const imaging::ViewWindow> windows = {});
    void draw(ViewSource& source, const Perspective& perspective, const Layers& layers, double ahead,
              std::size_t i) noexcept;
    std::vector<imaging::ColorImage> colors;
    std::vector<imaging::DepthImage> depths;
    std::vector<imaging::LabelImage> labels;
  };

  void measure(std::span<double> values) noexcept override;
  void start() override;
  void memory(StateArchive& archive) override;
  void draw_anew(std::uint64_t seed) override { noise_.reseed(seed); }
  void taken(std::uint64_t sample) noexcept override;
  void arrived(std::uint64_t sample) noexcept override;

  template <class Pixel>
  void fit(bool wanted, imaging::Image<Pixel>& image) const;
  void expose(View& picture) noexcept;
  /// Looks `ahead` [s] of the sample, and later for later rows.
  void look_at_all_rows(double ahead, const Layers& layers, View& picture) noexcept;
  void look(const imaging::Rows& rows, double ahead, const Layers& layers, View& picture) noexcept;
  void develop(std::uint64_t sample, imaging::ColorImage& color, imaging::GrayImage& mosaic) noexcept;

  CameraSpec spec_;
  Vec3d mounting_error_;
  Mounting mounting_;
  std::function<ViewSource*()> find_source_;
  CameraFrame& frame_;
  imaging::ImageNoise noise_;
  std::optional<imaging::BayerPattern> pattern_;
  ViewSource* source_ = nullptr;  // none: it draws nothing
  std::shared_ptr<const imaging::LensMap> map_;
  Windows windows_;
  std::optional<imaging::LightMean> mean_;
  std::optional<imaging::GaussianBlur> blur_;
  std::optional<imaging::Exposure> exposure_;
  std::vector<Picture> on_the_way_;
  std::shared_ptr<const std::string> fold_remark_;  // empty: the lens is fine
  imaging::ColorImage colors_behind_;               // a mosaic's; memory that pictures take turns in
};

}  // namespace murosimf::sensors
