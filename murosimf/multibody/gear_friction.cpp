#include "murosimf/multibody/gear_friction.h"

#include <algorithm>

#include "murosimf/math/exponential.h"
#include "murosimf/math/pack.h"

namespace murosimf::multibody {
namespace {

constexpr double least_exponent = 0.5, largest_exponent = 10, least_rate = 0.01;
constexpr double decayed = 20;  // x in s = exp(-x) from which on s counts as 0: it is 2e-9

/// A ratio |w|/v_s that is fast for this exponent: its power is above `decayed`. No power is needed to say so.
double fast_ratio(double alpha) {
  if (alpha >= 4) return 2.12;
  if (alpha >= 2) return 4.48;
  if (alpha >= 1.5) return 7.37;
  return alpha >= 1 ? 20.01 : 400.1;
}

bool rises_at_rest(const GearFriction& k) {
  return k.stribeck_rate > 0 && (k.stribeck > 0 || k.stribeck_motor_load > 0 || k.stribeck_external_load > 0 ||
                                 k.quadratic_motor_load > 0 || k.quadratic_external_load > 0);
}

/// ratio^alpha for ratio >= 0, at most `decayed`.
template <class S>
S power(const S& ratio, double alpha) {
  if (alpha == 1) return select(ratio > S(decayed), S(decayed), ratio);
  const S positive = select(ratio < S(1e-30), S(1e-30), ratio);
  const S exponent = alpha * logarithm(positive);
  const S largest = 2.9957322735539909;  // log(decayed)
  return exponential(select(exponent > largest, largest, exponent));
}

/// s = exp(-|w/v_s|^alpha): 1 at rest, 0 when fast. The shortcuts give what the long way gives.
template <class S>
S stribeck_share(const GearFriction& k, const S& rate) {
  const double alpha = std::clamp(k.stribeck_exponent, least_exponent, largest_exponent);
  const S ratio = abs(rate) * (1 / std::max(least_rate, k.stribeck_rate));
  const auto moves = ratio > S(0.0);
  if (!any(moves)) return 1.0;
  S share = 0.0;
  if (any(ratio < S(fast_ratio(alpha)))) {
    const S x = power(ratio, alpha);
    share = select(x < S((1 - 1e-9) * decayed), exponential(-x), S(0.0));
  }
  return select(moves, share, S(1.0));
}

/// |a tau_m - b tau_e|
template <class S>
S of_loads(double a, const S& motor, double b, const S& external) {
  return abs(a * motor - b * external);
}

/// Q: see the header.
template <class S>
S quadratic(const GearFriction& k, const S& motor, const S& external) {
  const auto driven_by_load = abs(motor) < abs(external);
  const S q =
      select(driven_by_load, k.quadratic_motor_load * motor * motor, k.quadratic_external_load * external * external);
  return select(motor * external < S(0.0), q, S(0.0));
}

}  // namespace

template <class S>
S dry_friction(const GearFriction& k, const S& rate, const S& motor, const S& external) noexcept {
  S budget = k.coulomb;
  if (k.motor_load > 0 || k.external_load > 0)
    budget = budget + of_loads(k.motor_load, motor, k.external_load, external);
  if (!rises_at_rest(k)) return budget;
  S more = k.stribeck;
  if (k.stribeck_motor_load > 0 || k.stribeck_external_load > 0) {
    more = more + of_loads(k.stribeck_motor_load, motor, k.stribeck_external_load, external);
  }
  if (k.quadratic_motor_load > 0 || k.quadratic_external_load > 0) more = more + quadratic(k, motor, external);
  return budget + stribeck_share(k, rate) * more;
}

template double dry_friction<double>(const GearFriction&, const double&, const double&, const double&) noexcept;
template Pack8 dry_friction<Pack8>(const GearFriction&, const Pack8&, const Pack8&, const Pack8&) noexcept;

}  // namespace murosimf::multibody
