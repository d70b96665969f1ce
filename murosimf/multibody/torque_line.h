/// torque_line.h - a torque that is linear in the joint's acceleration of this step, and a motor's, which has bounds.
#pragma once

#include <limits>

#include "murosimf/math/inline.h"
#include "murosimf/math/scalar.h"

namespace murosimf::multibody {

/// tau = torque - inertia qdd
template <class S>
struct TorqueLine {
  S torque{};   ///< [N m | N] after a step without acceleration
  S inertia{};  ///< [kg m^2 | kg] how fast that falls with the acceleration

  /// In lanes: where they are the same.
  [[nodiscard]] friend auto operator==(const TorqueLine& a, const TorqueLine& b) {
    return (a.torque == b.torque) & (a.inertia == b.inertia);
  }
};

/// What a motor makes: `free` as far as it stays between `lowest` and `highest`, else the one of these that it would cross.
template <class S>
struct MotorTorque {
  static constexpr double unbounded = std::numeric_limits<double>::infinity();

  S now{};  ///< [N m | N] at the beginning of the step
  TorqueLine<S> free;
  TorqueLine<S> highest{unbounded};
  TorqueLine<S> lowest{-unbounded};
};

/// Where a motor is beyond a bound in a step whose acceleration is `push` / D with the free line. Each line falls with the acceleration,
/// and so does all that acts in a joint: there the bound is the true line, also where that gives another acceleration.
/// D [kg m^2 | kg] > 0 is with the free line's inertia.
template <class S>
[[nodiscard]] MUROSIMF_INLINE auto is_over(const MotorTorque<S>& motor, const S& D, const S& push) {
  return (motor.free.torque - motor.highest.torque) * D > (motor.free.inertia - motor.highest.inertia) * push;
}
template <class S>
[[nodiscard]] MUROSIMF_INLINE auto is_under(const MotorTorque<S>& motor, const S& D, const S& push) {
  return (motor.free.torque - motor.lowest.torque) * D < (motor.free.inertia - motor.lowest.inertia) * push;
}

/// The line that the motor follows in that step.
template <class S>
[[nodiscard]] MUROSIMF_INLINE TorqueLine<S> followed_line(const MotorTorque<S>& motor, const S& D, const S& push) {
  const TorqueLine<S>& free = motor.free;
  const auto over = is_over(motor, D, push), under = is_under(motor, D, push);
  return {select(over, motor.highest.torque, select(under, motor.lowest.torque, free.torque)),
          select(over, motor.highest.inertia, select(under, motor.lowest.inertia, free.inertia))};
}

}  // namespace murosimf::multibody
