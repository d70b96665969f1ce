/// camera_model.h - the part of a camera that makes pictures: what its lens sees, and what becomes of the light (camera.h).
///
/// Produces pictures for any pose of a camera: for the camera itself, and for observers outside the simulation.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "murosimf/imaging/bayer.h"
#include "murosimf/imaging/exposure.h"
#include "murosimf/imaging/gaussian_blur.h"
#include "murosimf/imaging/image_noise.h"
#include "murosimf/imaging/lens_map.h"
#include "murosimf/imaging/vignette.h"
#include "murosimf/imaging/white_balance.h"
#include "murosimf/sensors/camera_spec.h"

namespace murosimf::sensors {

/// Optical axes to those of a camera: x to the right is -y, y down is -z, z forward is x.
inline constexpr Mat3d optical_axes{{0, -1, 0}, {0, 0, -1}, {1, 0, 0}};

/// Where a camera is, and how it moves.
struct CameraMotion {
  Vec3d position;          ///< [m] world
  Mat3d orientation;       ///< axes of the sensor (x forward) to world axes
  Vec3d velocity;          ///< [m/s] world
  Vec3d angular_velocity;  ///< [rad/s] world axes
};

struct CameraPicture {
  View view;
  imaging::GrayImage mosaic;
};

class CameraModel {
 public:
  /// `noise` distinguishes cameras. Throws SetupError that names what is impossible.
  CameraModel(const CameraSpec& spec, const RandomStream& noise);

  /// Before the first picture: makes what it needs, some of which takes long and is shared by equal cameras.
  void open();
  /// `number`: of the picture, for its noise. Layers that it does not have stay as they are.
  void take(ViewSource& source, const CameraMotion& motion, std::uint64_t number, CameraPicture& picture) noexcept;

  /// Noise of another seed.
  void reseed(std::uint64_t seed) noexcept { noise_.reseed(seed); }
  [[nodiscard]] const CameraSpec& spec() const { return spec_; }
  /// It shows mosaics instead of colors.
  [[nodiscard]] bool has_mosaic() const { return pattern_.has_value(); }

 private:
  /// What was drawn for each view of the lens map.
  struct Windows {
    explicit Windows(std::span<const imaging::ViewWindow> windows = {});
    void draw(ViewSource& source, const Perspective& perspective, const Layers& layers, double ahead,
              std::size_t i) noexcept;
    std::vector<imaging::ColorImage> colors;
    std::vector<imaging::DepthImage> depths;
    std::vector<imaging::LabelImage> labels;
  };

  template <class Pixel>
  void fit(bool wanted, imaging::Image<Pixel>& image) const;
  void expose(ViewSource& source, const CameraMotion& motion, View& picture) noexcept;
  /// Looks `ahead` [s] of the sample, and later for later rows.
  void look_at_all_rows(ViewSource& source, const CameraMotion& motion, double ahead, const Layers& layers,
                        View& picture) noexcept;
  void look(ViewSource& source, const CameraMotion& motion, const imaging::Rows& rows, double ahead,
            const Layers& layers, View& picture) noexcept;
  void develop(std::uint64_t number, imaging::ColorImage& color, imaging::GrayImage& mosaic) noexcept;

  CameraSpec spec_;
  imaging::ImageNoise noise_;
  std::optional<imaging::BayerPattern> pattern_;
  std::shared_ptr<const imaging::LensMap> map_;
  Windows windows_;
  std::optional<imaging::LightMean> mean_;
  std::optional<imaging::GaussianBlur> blur_;
  std::optional<imaging::Exposure> exposure_;
  std::optional<imaging::Vignette> vignette_;
  std::optional<imaging::WhiteBalance> white_balance_;
};

/// The stream of a camera's noise.
[[nodiscard]] RandomStream pixel_stream(std::uint64_t seed, const std::string& robot, const std::string& camera);

/// Where the lens folds over, as a diagnostic for its user; empty: nowhere. Looking for it turns the lens round for thousands of pixels: equal
/// cameras share it.
[[nodiscard]] std::shared_ptr<const std::string> shared_fold_warning(const imaging::LensSpec& lens);

}  // namespace murosimf::sensors
