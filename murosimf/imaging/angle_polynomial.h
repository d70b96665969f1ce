/// angle_polynomial.h - lenses that bend a ray by its angle from the optical axis: equidistant and ray_polynomial.
///
///     r = a1 t + a2 t^2 + ... + a9 t^9
///
/// t [rad] is the angle of the ray, r the distance of its point from the center of the picture at focal length 1.
/// Sources: Kannala, Brandt, "A generic camera model and calibration method for conventional, wide-angle, and fish-eye
/// lenses", IEEE PAMI 28 (2006), which has odd powers only; the paper's section 6.2, which has six powers.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "murosimf/math/monotonic_root.h"

namespace murosimf::imaging {

class AnglePolynomial {
 public:
  /// a1 = 1 and the coefficients k1, k2, ... of t^3, t^5, ..., at most 4.
  [[nodiscard]] static AnglePolynomial equidistant(std::span<const double> k);
  /// The coefficients of t, t^2, ..., at most 6.
  [[nodiscard]] static AnglePolynomial powers(std::span<const double> a);

  /// r and dr/dt at `angle`.
  [[nodiscard]] Slope at(double angle) const noexcept;
  /// Up to this angle r increases; pi if everywhere.
  [[nodiscard]] double widest_angle() const noexcept { return widest_; }
  /// The angle at which r is `radius`; nothing beyond the widest.
  [[nodiscard]] std::optional<double> angle(double radius) const noexcept;

 private:
  void find_widest();

  std::array<double, 9> a_{};  ///< a1 to a9
  double widest_ = 0;          ///< [rad]
};

}  // namespace murosimf::imaging
