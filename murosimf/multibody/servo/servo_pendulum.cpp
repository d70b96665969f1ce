#include "murosimf/multibody/servo/servo_pendulum.h"

#include "murosimf/math/assert.h"
#include "murosimf/math/pack.h"
#include "murosimf/multibody/servo/gear_friction.h"

namespace murosimf::multibody {
namespace {

/// x limited to the range from low to high.
template <class S>
S clamp(const S& x, const S& low, const S& high) {
  const S cut = select(x < low, low, x);
  return select(cut > high, high, cut);
}

/// Duty that the firmware gives.
template <class S>
struct Duty {
  S value;
  S slope;  ///< [1/rad] its decrease with the angle: the gain, or 0 where a limit clamps it
};

template <class S>
Duty<S> duty_of(const BenchServo& servo, const S& gain, const BenchInput<S>& input, const BenchState<S>& state) {
  // the current limit first, the duty limit last, as in firmware: at high rates the current cannot be limited by the duty
  const S wanted = gain * (input.goal - state.position);
  S given = wanted;
  if (servo.current_limit > 0) {
    const S middle = servo.torque_constant * state.rate / input.voltage;
    const S half = servo.resistance * servo.current_limit / input.voltage;
    given = clamp<S>(given, middle - half, middle + half);
  }
  given = clamp<S>(given, -servo.duty_limit, servo.duty_limit);
  return {given, select(given == wanted, gain, S(0.0))};
}

/// Returns sign(p) max(0, |p| - most).
template <class S>
S shrink(const S& p, const S& most) {
  const S left = abs(p) - most;
  const S size = select(left > S(0.0), left, S(0.0));
  return select(p < S(0.0), -size, select(p > S(0.0), size, p));
}

}  // namespace

template <class S>
void advance(const BenchServo& servo, const Bench<S>& bench, const BenchInput<S>& input, double h,
             BenchState<S>& state) noexcept {
  MUROSIMF_ASSERT(h > 0 && servo.resistance > 0);
  const S per_volt = input.enabled * (servo.torque_constant / servo.resistance);
  const S brake = per_volt * servo.torque_constant;
  const Duty<S> duty = duty_of(servo, bench.gain, input, state);
  const S torque_at_rest = per_volt * duty.value * input.voltage;
  const S external = -bench.weight * sin_cos<S>(state.position + servo.encoder_offset).sin;
  const S budget = dry_friction<S>(servo.friction, state.rate, torque_at_rest - brake * state.rate, external);

  const S inertia = bench.inertia + servo.rotor_inertia;
  // what is linear in the new rate goes to the left side: stable for any step
  const S stiffness = per_volt * input.voltage * duty.slope;
  const S resistance = inertia + h * (brake + servo.friction.viscous) + h * h * stiffness;
  const S momentum = inertia * state.rate + h * (torque_at_rest + external);
  state.rate = shrink<S>(momentum, h * budget) / resistance;
  state.position = state.position + h * state.rate;
}

template void advance<double>(const BenchServo&, const Bench<double>&, const BenchInput<double>&, double,
                              BenchState<double>&) noexcept;
template void advance<Pack8>(const BenchServo&, const Bench<Pack8>&, const BenchInput<Pack8>&, double,
                             BenchState<Pack8>&) noexcept;

}  // namespace murosimf::multibody
