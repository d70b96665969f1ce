/// torque_line.h - torques that are linear in the joint's acceleration of this step: of a motor, with its limits, and of an end
/// of the joint's range, which acts beyond the end.
#pragma once

#include <limits>

#include "murosimf/math/inline.h"
#include "murosimf/math/scalar.h"

namespace murosimf::multibody {

/// tau = torque - inertia qdd
template <class S>
struct TorqueLine {
  S torque{};   ///< [N m | N] after a step without acceleration
  S inertia{};  ///< [kg m^2 | kg] decrease of the torque with the acceleration

  /// In lanes: where they are equal.
  [[nodiscard]] friend auto operator==(const TorqueLine& a, const TorqueLine& b) {
    return (a.torque == b.torque) & (a.inertia == b.inertia);
  }
};

/// Whether the first of two lines is above the second one at the acceleration `push` / D, D [kg m^2 | kg] > 0; in lanes: where.
template <class S>
[[nodiscard]] MUROSIMF_INLINE auto is_above(const TorqueLine<S>& one, const TorqueLine<S>& other, const S& D,
                                            const S& push) {
  return (one.torque - other.torque) * D > (one.inertia - other.inertia) * push;
}

/// Torque of a motor: `free`, limited by `ceiling` and `floor`, and finally by `lowest` and `highest`.
template <class S>
struct MotorTorque {
  static constexpr double unbounded = std::numeric_limits<double>::infinity();

  S now{};  ///< [N m | N] at the beginning of the step
  TorqueLine<S> free;
  TorqueLine<S> highest{unbounded};
  TorqueLine<S> lowest{-unbounded};
  TorqueLine<S> ceiling{unbounded};  ///< upper limit due to the limit of its rate
  TorqueLine<S> floor{-unbounded};   ///< likewise, lower
};

/// Whether the free line is beyond another one at the acceleration `push` / D, in any lane.
template <class S>
[[nodiscard]] MUROSIMF_INLINE bool leaves_free_line(const MotorTorque<S>& motor, const S& D, const S& push) {
  const auto above = is_above(motor.free, motor.highest, D, push), below = is_above(motor.lowest, motor.free, D, push);
  const auto rises = is_above(motor.free, motor.ceiling, D, push), falls = is_above(motor.floor, motor.free, D, push);
  return any(above | below | rises | falls);  // one question for all: in lanes each takes an instruction and a branch
}

/// The line that a motor changes to from `line`, which gives the acceleration `push` / D: the lowest one that it must not be above,
/// else the highest that it must not be below. From a limit of the rate it changes to one of the torque, and from there to none. Each
/// line falls with the acceleration, and so does all that acts in a joint: of two lines, the relevant one shows at the acceleration of
/// either. So the line is found after at most lines_in_turn lines.
template <class S>
[[nodiscard]] MUROSIMF_INLINE TorqueLine<S> followed_line(const MotorTorque<S>& motor, const TorqueLine<S>& line,
                                                          const S& D, const S& push) {
  const auto chosen = [](const auto& where, const TorqueLine<S>& one, const TorqueLine<S>& other) {
    return TorqueLine<S>{select(where, one.torque, other.torque), select(where, one.inertia, other.inertia)};
  };
  const auto lower = [&](const TorqueLine<S>& one, const TorqueLine<S>& other) {
    return chosen(is_above(one, other, D, push), other, one);
  };
  const auto higher = [&](const TorqueLine<S>& one, const TorqueLine<S>& other) {
    return chosen(is_above(other, one, D, push), other, one);
  };
  const auto free = line == motor.free, last = (line == motor.highest) | (line == motor.lowest);
  const TorqueLine<S> high = chosen(free, lower(motor.ceiling, motor.highest), motor.highest);
  const TorqueLine<S> low = chosen(free, higher(motor.floor, motor.lowest), motor.lowest);
  return chosen(last, line, chosen(is_above(line, high, D, push), high, higher(line, low)));
}
constexpr int lines_in_turn = 3;

/// The same, from the free line.
template <class S>
[[nodiscard]] MUROSIMF_INLINE TorqueLine<S> followed_line(const MotorTorque<S>& motor, const S& D, const S& push) {
  return followed_line(motor, motor.free, D, push);
}

/// The nearer end of a joint's range: its line acts where the step's acceleration takes the joint beyond it.
template <class S>
struct RangeEnd {
  S direction = 1.0;                                ///< 1: upwards, -1: downwards
  S gap = std::numeric_limits<double>::infinity();  ///< [rad | m] distance to it after a step without acceleration
  TorqueLine<S> line;
};

/// Whether a step of `dt` [s] whose acceleration is `push` / D without the end goes beyond it.
template <class S>
[[nodiscard]] MUROSIMF_INLINE auto is_beyond(const RangeEnd<S>& end, const S& D, const S& push, double dt) {
  return end.direction * push * (dt * dt) > end.gap * D;
}

}  // namespace murosimf::multibody
