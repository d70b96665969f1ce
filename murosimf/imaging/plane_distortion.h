/// plane_distortion.h - lenses that move points of the plane z = 1: plumb_bob and rational_polynomial.
///
///     s  = (1 + k1 r^2 + k2 r^4 + k3 r^6) / (1 + k4 r^2 + k5 r^4 + k6 r^6),   r^2 = x^2 + y^2
///     x' = s x + 2 p1 x y + p2 (r^2 + 2 x^2)
///     y' = s y + p1 (r^2 + 2 y^2) + 2 p2 x y
///
/// Sources: Brown, "Decentering distortion of lenses", Photogrammetric Engineering 32 (1966); names and denominator as
/// in OpenCV's documentation of camera calibration.
#pragma once

#include <optional>
#include <span>

#include "murosimf/math/monotonic_root.h"

namespace murosimf::imaging {

/// A point of the plane z = 1 in the optical frame.
struct PlanePoint {
  double x = 0, y = 0;
};

/// Where a point goes, and the derivatives of that: xy is that of x' by y.
struct PlaneMotion {
  PlanePoint to;
  double xx, xy, yx, yy;

  [[nodiscard]] double determinant() const { return xx * yy - xy * yx; }
};

class PlaneDistortion {
 public:
  /// Coefficients k1 k2 p1 p2 k3 k4 k5 k6; those that are not given are 0, so with none nothing moves.
  explicit PlaneDistortion(std::span<const double> coefficients);
  /// The same with `at` only: where it folds is not looked for.
  [[nodiscard]] static PlaneDistortion formula(std::span<const double> coefficients);

  [[nodiscard]] PlaneMotion at(const PlanePoint& p) const noexcept;
  /// Up to this angle from the axis [rad] no two points go to one place; pi/2 if everywhere.
  [[nodiscard]] double widest_angle() const noexcept { return widest_; }
  /// Is the point within the widest angle?
  [[nodiscard]] bool reaches(const PlanePoint& p) const noexcept { return p.x * p.x + p.y * p.y <= reach_ * reach_; }
  /// The point that goes to `distorted`; nothing if none within the widest angle does.
  [[nodiscard]] std::optional<PlanePoint> undistorted(const PlanePoint& distorted) const noexcept;

 private:
  PlaneDistortion() = default;

  struct Scale {
    double value, slope;  ///< s, and its derivative by r^2
    bool regular;         ///< the denominator has not passed zero
  };
  [[nodiscard]] Scale scale(double r2) const noexcept;
  [[nodiscard]] Slope radial(double r) const noexcept;
  void find_widest();
  [[nodiscard]] bool folds(double r, const PlanePoint& direction) const;
  [[nodiscard]] double fold(double direction) const;
  [[nodiscard]] PlanePoint without_tangential(const PlanePoint& distorted) const noexcept;
  [[nodiscard]] std::optional<PlanePoint> refined(PlanePoint p, const PlanePoint& distorted) const noexcept;

  double k1_ = 0, k2_ = 0, k3_ = 0, k4_ = 0, k5_ = 0, k6_ = 0, p1_ = 0, p2_ = 0;
  double widest_ = 0, reach_ = 0;  ///< the angle [rad], and its tangent
};

}  // namespace murosimf::imaging
