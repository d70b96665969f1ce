/// scalar.h - what kernels ask of a number.
///
/// Kernels are templates on their scalar S: `double`, or a `Pack` of eight doubles that behaves like one number
/// (pack.h). They branch with `if` on structure, which all lanes share, and with `select` on values, which they do
/// not. The sine and cosine here are polynomials, the same operations for every scalar and on every machine, so that
/// a lane equals the robot stepped alone bit for bit.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "murosimf/math/inline.h"

namespace murosimf {

inline constexpr double pi = std::numbers::pi;

/// The type of the product of two scalars: double * Pack = Pack.
template <class A, class B>
using Product = decltype(A{} * B{});

inline double select(bool mask, double yes, double no) { return mask ? yes : no; }
inline bool any(bool mask) { return mask; }
inline bool all(bool mask) { return mask; }
inline double sqrt(double x) { return std::sqrt(x); }
inline double abs(double x) { return std::fabs(x); }

inline constexpr double round_bias = 6755399441055744.0;            // 1.5 * 2^52: adding it rounds to an integer
inline constexpr double exponent_bias = 4503599627370496.0 + 1023;  // 2^52 and the bias of IEEE 754 binary64
inline constexpr std::int64_t two_to_52_bits = 0x4330000000000000;  // of 2^52: small integers go below
inline constexpr std::int64_t fraction_mask = 0x000fffffffffffff;   // bits of the fraction
inline constexpr std::int64_t one_bits = 0x3ff0000000000000;        // of 1.0

/// e of x = f 2^e with 1 <= f < 2, for positive normal x.
inline double binary_exponent(double x) {
  return std::bit_cast<double>((std::bit_cast<std::int64_t>(x) >> 52) | two_to_52_bits) - exponent_bias;
}
/// f of x = f 2^e with 1 <= f < 2, for positive normal x.
inline double binary_fraction(double x) {
  return std::bit_cast<double>((std::bit_cast<std::int64_t>(x) & fraction_mask) | one_bits);
}
/// x 2^n for an integer n, if x and the result are normal.
inline double times_power_of_two(double x, double n) {
  const auto shift = std::bit_cast<std::uint64_t>(n + round_bias) << 52;
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) + shift);
}

template <class S>
struct SinCos {
  S sin, cos;
};

/// Sine and cosine of `angle` [rad], |angle| < 1e5; absolute error below 2e-16 for |angle| < 10.
/// Method: reduce by multiples of pi/2 in three parts (Cody and Waite), then the minimax polynomials of the Cephes
/// library's sin.c (S. L. Moshier, public figures) on +-pi/4.
template <class S>
MUROSIMF_INLINE SinCos<S> sin_cos(S angle) {
  constexpr double half_pi_a = 1.57079625129699707031;
  constexpr double half_pi_b = 7.54978941586159635335e-8;
  constexpr double half_pi_c = 5.39030252995776476554e-15;

  const S turns = (angle * (2.0 / pi) + round_bias) - round_bias;
  const S x = ((angle - turns * half_pi_a) - turns * half_pi_b) - turns * half_pi_c;
  const S z = x * x;
  // clang-format off
  const S s = x + x * z * (((((1.58962301576546568060e-10  * z - 2.50507477628578072866e-8) * z
                             + 2.75573136213857245213e-6) * z - 1.98412698295895385996e-4) * z
                             + 8.33333333332211858878e-3) * z - 1.66666666666666307295e-1);
  const S c = 1.0 - 0.5 * z + z * z * (((((-1.13585365213876817300e-11 * z + 2.08757008419747316778e-9) * z
                                          - 2.75573141792967388112e-7) * z + 2.48015872888517045348e-5) * z
                                          - 1.38888888888730564116e-3) * z + 4.16666666666665929218e-2);
  // clang-format on

  // quadrant = turns mod 4, in {-2, -1, 0, 1, 2}
  const S quadrant = turns - 4.0 * ((turns * 0.25 + round_bias) - round_bias);
  const auto odd = abs(quadrant) == S(1.0);
  const S sin_base = select(odd, c, s);
  const S cos_base = select(odd, s, c);
  const auto sin_negative = (quadrant < S(-0.5)) | (quadrant > S(1.5));
  const auto cos_negative = (quadrant > S(0.5)) | (quadrant < S(-1.5));
  return {select(sin_negative, -sin_base, sin_base), select(cos_negative, -cos_base, cos_base)};
}

/// True if all of these numbers are exactly zero, whatever their sign: by their bits, without a branch for each.
template <class... Numbers>
[[nodiscard]] MUROSIMF_INLINE bool are_zero(Numbers... numbers) {
  return ((std::bit_cast<std::uint64_t>(numbers) | ...) << 1) == 0;
}

}  // namespace murosimf
