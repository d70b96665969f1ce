/// exponential.h - exp, log and a power's decay as polynomials: the same operations for every scalar.
///
/// Like sin_cos (scalar.h): no library call, so that a lane equals the robot stepped alone bit for bit, on every machine.
#pragma once

#include "murosimf/math/scalar.h"

namespace murosimf {

inline constexpr double ln_2_high = 6.93147180369123816490e-01;  // its last 20 bits are zero: products with n are exact
inline constexpr double ln_2_low = 1.90821492927058770002e-10;

/// e^x for |x| <= 700; relative error below 2.3e-16 + 1.1e-16.
/// Method: x = n ln 2 + r, |r| <= ln 2/2; e^r = 1 + 2 r/(c - r) with c = r coth(r/2), an even function whose minimax
/// polynomial has the public figures of fdlibm's e_exp.c (Sun Microsystems 1993).
template <class S>
[[gnu::always_inline]] inline S exponential(const S& x) {
  const S n = (x * std::numbers::log2e + round_bias) - round_bias;
  const S high = x - n * ln_2_high;
  const S low = n * ln_2_low;
  const S r = high - low;
  const S z = r * r;
  // clang-format off
  const S c = r - z * (1.66666666666666019037e-01 + z * (-2.77777777770155933842e-03
                + z * (6.61375632143793436117e-05 + z * (-1.65339022054652515390e-06
                + z * 4.13813679705723846039e-08))));
  // clang-format on
  const S y = 1.0 - ((low - (r * c) / (2.0 - c)) - high);
  return times_power_of_two(y, n);
}

/// Natural logarithm of a positive normal number; relative error below 1e-15 where |log x| > 1e-10, absolute 1e-16.
/// Method: x = f 2^n with f in [sqrt(1/2), sqrt(2)); log f = 2 artanh(s), s = (f - 1)/(f + 1), an odd function whose
/// minimax polynomial has the public figures of fdlibm's e_log.c (Sun Microsystems 1993).
template <class S>
[[gnu::always_inline]] inline S logarithm(const S& x) {
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
