/// tendon_tie.h - a tendon whose length is held where that of another one says, or at one place: a relation of their sliders
/// (joint_tendon.h, spatial_tendon.h)
///
///     L = start + a_0 + a_1 x + a_2 x^2 + a_3 x^3 + a_4 x^4,   x = L_other - other_start
///
/// Source: MuJoCo documentation, XML reference, "equality", "tendon".
#pragma once

#include <array>
#include <string>

#include "murosimf/model/property.h"

namespace murosimf {

struct TendonTie {
  std::string other;                                ///< name of the other tendon's slider; empty: none, x = 0
  double start = 0, other_start = 0;                ///< [m | rad] lengths from which they are counted
  std::array<double, 5> polynomial{0, 1, 0, 0, 0};  ///< a_0 to a_4

  /// [m | rad] L where the other one is `length` [m | rad] long.
  [[nodiscard]] double at(double length) const noexcept {
    const auto& a = polynomial;
    const double x = other.empty() ? 0 : length - other_start;
    return start + a[0] + x * (a[1] + x * (a[2] + x * (a[3] + x * a[4])));
  }
  /// [1] dL/dx there.
  [[nodiscard]] double slope(double length) const noexcept {
    const auto& a = polynomial;
    const double x = length - other_start;
    return a[1] + x * (2 * a[2] + x * (3 * a[3] + x * 4 * a[4]));
  }
};

}  // namespace murosimf

namespace murosimf::properties {

inline constexpr Property<TendonTie> tendon_tie{
    {"tendon_tie", "-", "joint", "the tendon whose length says how long this one is"}};

}  // namespace murosimf::properties
