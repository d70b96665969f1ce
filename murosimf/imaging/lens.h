/// lens.h - which pixel a point is seen in, and along which ray a pixel looks, for real lenses.
///
/// Points and rays are in the optical frame of the camera: x right, y down, z forward (REP 103); pixels are those of
/// imaging/image.h. With x' and y' the coordinates in the picture at focal length 1,
///
///     u = fx x' + s y' + cx,  v = fy y' + cy
///
/// with the skew s of a sensor whose rows and columns are not at right angles, and the models differ in how (x', y') follows
/// from the ray:
///
///     perspective          none                      x' = x / z, y' = y / z
///     plumb_bob            k1 k2 p1 p2 [k3]          imaging/plane_distortion.h
///     rational_polynomial  k1 k2 p1 p2 k3 k4 k5 k6   imaging/plane_distortion.h
///     equidistant          k1 [k2 [k3 [k4]]]         imaging/angle_polynomial.h: r = t (1 + k1 t^2 + k2 t^4 + ...)
///     ray_polynomial       a1 [a2 ... [a6]]          imaging/angle_polynomial.h: r = a1 t + a2 t^2 + ... (the paper's)
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "murosimf/imaging/angle_polynomial.h"
#include "murosimf/imaging/plane_distortion.h"
#include "murosimf/math/vec3.h"

namespace murosimf::imaging {

/// A place in a picture [px], between pixels too (imaging/image.h).
struct Pixel {
  double u = 0, v = 0;
};

/// The numbers of a camera's calibration.
struct LensSpec {
  std::string model = "perspective";
  int width = 640, height = 480;       ///< of the picture [px]
  double fx = 0, fy = 0;               ///< focal length [px]
  double cx = 0, cy = 0;               ///< where the optical axis meets the picture [px]
  std::vector<double> coefficients{};  ///< of the model, in the order above
  double skew = 0;                     ///< s [px]: K[0][1] of the camera matrix, alpha_c fx of the toolbox for Matlab
};

/// Where a point (x', y') of the picture at focal length 1 is seen.
[[nodiscard]] Pixel pixel_at(const LensSpec& spec, const PlanePoint& d) noexcept;

/// How far a picture reaches from side to side through its center, and from corner to corner [rad].
struct Fov {
  double horizontal, vertical, diagonal;
};

/// The names of the models.
[[nodiscard]] const std::vector<std::string_view>& lens_models();

class Lens {
 public:
  /// Throws SetupError: unknown model, size not 1 to 8192 px, focal length not positive, center more than a picture's
  /// size outside of it, skew not below fx, wrong number of coefficients, numbers that are not finite, or a lens that folds at
  /// its center.
  explicit Lens(const LensSpec& spec);

  [[nodiscard]] const LensSpec& spec() const noexcept { return spec_; }
  /// A picture of straight lines and right angles: perspective, or a lens of the plane whose coefficients are 0; without skew.
  [[nodiscard]] bool plain() const noexcept;

  /// The pixel in which the point [m, optical frame] is seen, inside the picture or not. Nothing if the lens cannot see
  /// it: the point is behind it, or beyond its widest angle.
  [[nodiscard]] std::optional<Pixel> project(const Vec3d& point) const noexcept;
  /// The unit vector along which a pixel looks. Nothing beyond the widest angle.
  [[nodiscard]] std::optional<Vec3d> ray(const Pixel& pixel) const noexcept;

  /// Up to this angle from the optical axis [rad] points farther out are seen farther out. Beyond it a distortion folds
  /// over. Without a fold pi/2 for lenses of the plane (perspective, plumb_bob, rational_polynomial), else pi.
  [[nodiscard]] double widest_angle() const noexcept;
  /// The largest angle from the optical axis inside the picture [rad]: that of a corner, or the widest.
  [[nodiscard]] double corner_angle() const noexcept;
  [[nodiscard]] Fov fov() const noexcept;
  /// Empty, or "the distortion folds over at 47.1 deg, inside the picture: 9.0 % of the pixels see nothing".
  [[nodiscard]] std::string fold_warning() const;

 private:
  /// From the optical axis [rad]; the widest angle where there is no ray.
  [[nodiscard]] double angle(const Pixel& pixel) const noexcept;

  LensSpec spec_;
  std::variant<std::shared_ptr<const PlaneDistortion>, AnglePolynomial> map_;  // equal distortions of the plane are one
};

}  // namespace murosimf::imaging
