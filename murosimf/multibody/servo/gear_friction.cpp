#include "murosimf/multibody/servo/gear_friction.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "murosimf/math/assert.h"
#include "murosimf/math/exponential.h"
#include "murosimf/math/pack.h"

namespace murosimf::multibody {
namespace {

constexpr double least_exponent = 0.5, largest_exponent = 10, least_rate = 0.01;  // of the header's documented range
constexpr double decayed = 20;  // exponent x from which on s = exp(-x) counts as 0: it is 2e-9

/// A ratio |w|/v_s whose power with this exponent is certainly above `decayed`: a comparison instead of a power.
double fast_ratio(double alpha) {
  MUROSIMF_ASSERT(!(alpha < least_exponent) && !(alpha > largest_exponent));
  if (alpha >= 4) return 2.12;
  if (alpha >= 2) return 4.48;
  if (alpha >= 1.5) return 7.37;
  return alpha >= 1 ? 20.01 : 400.1;
}

/// Whether the Stribeck part of the friction is not zero.
bool rises_at_rest(const GearFriction& k) {
  return k.stribeck_rate > 0 && (k.stribeck > 0 || k.stribeck_motor_load > 0 || k.stribeck_external_load > 0 ||
                                 k.quadratic_motor_load > 0 || k.quadratic_external_load > 0);
}

/// ratio^alpha for ratio >= 0, limited to `decayed`. A: double or S.
template <class S, class A>
S power(const S& ratio, const A& alpha) {
  const S linear = select(ratio > S(decayed), S(decayed), ratio);
  if constexpr (std::is_same_v<A, double>) {
    // the usual exponent, exact: s is then independent of the polynomial of the logarithm
    if (alpha == 1) return linear;
  }
  // the logarithm takes normal positive numbers only; at 1e-30 and alpha >= 0.5 the power is below 1e-15
  const S positive = select(ratio < S(1e-30), S(1e-30), ratio);
  const S exponent = alpha * logarithm(positive);
  const S largest = 2.9957322735539909;  // log(decayed)
  const S any_power = exponential(select(exponent > largest, largest, exponent));
  if constexpr (std::is_same_v<A, double>) return any_power;
  return select(S(alpha) == S(1.0), linear, any_power);
}

/// exp(-ratio^alpha) for ratio >= 0.
template <class S, class A>
S decay(const S& ratio, const A& alpha) {
  const S x = power(ratio, alpha);
  const S share = select(x < S((1 - 1e-9) * decayed), exponential(-x), S(0.0));
  return select(ratio > S(0.0), share, S(1.0));
}

double exponent_of(const GearFriction& k) { return std::clamp(k.stribeck_exponent, least_exponent, largest_exponent); }
double inverse_rate_of(const GearFriction& k) { return 1 / std::max(least_rate, k.stribeck_rate); }

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

/// s with the same bits as decay(): the shortcuts return exactly what the full computation returns.
template <class S>
S stribeck_share(const GearFriction& k, const S& rate) noexcept {
  if (!rises_at_rest(k)) return 0.0;
  const double alpha = exponent_of(k);
  const S ratio = abs(rate) * inverse_rate_of(k);
  const auto moves = ratio > S(0.0);
  if (!any(moves)) return 1.0;
  if (!any(ratio < S(fast_ratio(alpha)))) return select(moves, S(0.0), S(1.0));
  return decay(ratio, alpha);
}

template <class S>
S dry_friction_with_share(const GearFriction& k, const S& share, const S& motor, const S& external) noexcept {
  S budget = k.coulomb;
  if (k.motor_load > 0 || k.external_load > 0)
    budget = budget + of_loads(k.motor_load, motor, k.external_load, external);
  if (!rises_at_rest(k)) return budget;
  S more = k.stribeck;
  if (k.stribeck_motor_load > 0 || k.stribeck_external_load > 0) {
    more = more + of_loads(k.stribeck_motor_load, motor, k.stribeck_external_load, external);
  }
  if (k.quadratic_motor_load > 0 || k.quadratic_external_load > 0) more = more + quadratic(k, motor, external);
  return budget + share * more;
}

template <class S>
S dry_friction(const GearFriction& k, const S& rate, const S& motor, const S& external) noexcept {
  return dry_friction_with_share(k, stribeck_share(k, rate), motor, external);
}

void StribeckShares::add(const GearFriction& k, double rate, double& share) noexcept {
  if (!rises_at_rest(k)) return;
  MUROSIMF_ASSERT(count_ >= 0 && count_ < Pack8::lanes);
  ratio_.set_lane(count_, std::abs(rate) * inverse_rate_of(k));
  exponent_.set_lane(count_, exponent_of(k));
  shares_[static_cast<std::size_t>(count_)] = &share;
  if (++count_ == Pack8::lanes) write();
}

void StribeckShares::write() noexcept {
  if (count_ == 0) return;
  MUROSIMF_ASSERT(count_ <= Pack8::lanes);
  const Pack8 all =
      decay(ratio_, exponent_);  // unused lanes hold numbers of earlier joints: valid input, ignored output
  for (int lane = 0; lane < count_; ++lane) *shares_[static_cast<std::size_t>(lane)] = all.lane(lane);
  count_ = 0;
}

#define MUROSIMF_INSTANTIATE(S)                                                                      \
  template S stribeck_share<S>(const GearFriction&, const S&) noexcept;                              \
  template S dry_friction_with_share<S>(const GearFriction&, const S&, const S&, const S&) noexcept; \
  template S dry_friction<S>(const GearFriction&, const S&, const S&, const S&) noexcept;
MUROSIMF_INSTANTIATE(double)
MUROSIMF_INSTANTIATE(Pack8)
#undef MUROSIMF_INSTANTIATE

}  // namespace murosimf::multibody
