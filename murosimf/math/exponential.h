/// exponential.h - exp, log and a power's decay as polynomials: the same operations for every scalar.
///
/// Like sin_cos (scalar.h): no library call, so that a lane equals the robot stepped alone bit for bit, on every machine.
#pragma once

#include "murosimf/math/scalar.h"

namespace murosimf {

inline constexpr double ln_2_high = 6.93147180369123816490e-01;  // its last 20 bits are zero: products with n are exact
inline constexpr double ln_2_low = 1.90821492927058770002e-10;

/// e^x for |x| <= 700; relative error below 5e-16.
/// Method: x = n ln 2 + r, |r| <= ln 2/2 (Cody and Waite); Taylor's series of e^r to degree 12, whose rest is below 2e-16,
/// added up in pairs, so that the processor can do several at once. No division.
template <class S>
MUROSIMF_INLINE S exponential(const S& x) {
  const S n = (x * std::numbers::log2e + round_bias) - round_bias;
  const S r = (x - n * ln_2_high) - n * ln_2_low;
  const S r2 = r * r;
  const S r4 = r2 * r2;
  // clang-format off
  const S low   = r2 * (1.0 / 2 + r * (1.0 / 6));
  const S mid   = (1.0 / 24 + r * (1.0 / 120)) + r2 * (1.0 / 720 + r * (1.0 / 5040));
  const S high  = (1.0 / 40320 + r * (1.0 / 362880)) + r2 * (1.0 / 3628800 + r * (1.0 / 39916800));
  // clang-format on
  const S rest = r4 * (mid + r4 * (high + r4 * (1.0 / 479001600)));
  return times_power_of_two(1.0 + (r + (low + rest)), n);
}

/// Natural logarithm of a positive normal number; relative error below 1e-15 where |log x| > 1e-10, absolute 1e-16.
/// Method: x = f 2^n with f in [sqrt(1/2), sqrt(2)); log f = 2 artanh(s), s = (f - 1)/(f + 1), an odd function whose
/// minimax polynomial has the public figures of fdlibm's e_log.c (Sun Microsystems 1993).
template <class S>
MUROSIMF_INLINE S logarithm(const S& x) {
  const S fraction = binary_fraction(x);
  const auto large = fraction > S(std::numbers::sqrt2);
  const S f = select(large, fraction * 0.5, fraction) - 1.0;
  const S n = binary_exponent(x) + select(large, S(1.0), S(0.0));
  const S s = f / (f + 2.0);
  const S z = s * s;
  const S w = z * z;
  const S even = w * (3.999999999940941908e-01 + w * (2.222219843214978396e-01 + w * 1.531383769920937332e-01));
  const S odd = z * (6.666666666666735130e-01 +
                     w * (2.857142874366239149e-01 + w * (1.818357216161805012e-01 + w * 1.479819860511658591e-01)));
  const S half_square = 0.5 * f * f;
  return n * ln_2_high - ((half_square - (s * (half_square + (even + odd)) + n * ln_2_low)) - f);
}

}  // namespace murosimf
