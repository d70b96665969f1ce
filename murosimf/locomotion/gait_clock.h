/// gait_clock.h - phase, amplitude and velocity of a gait, which follow `walk_command`.
///
/// The velocity follows the command (zero while `halted` is not 0), clipped to the fastest, with limited accelerations. The amplitude goes to 1 while
/// something moves and to 0 otherwise; the phase runs while it is not 0. All are columns.
#pragma once

#include <optional>

#include "murosimf/math/scalar.h"
#include "murosimf/model/properties.h"
#include "murosimf/world/setup.h"

namespace murosimf::locomotion {

struct GaitLimits {
  double period = 0;                ///< [s]
  Vec3d slew;                       ///< [m/s^2, m/s^2, rad/s^2] of the velocity
  Vec3d fastest;                    ///< [m/s, m/s, rad/s]
  std::optional<Vec3d> velocity{};  ///< [m/s, m/s, rad/s] instead of walk_command
  Vec3d trim{};                     ///< [m/s, m/s, rad/s] added to it where it is not zero
};

class GaitClock {
 public:
  /// `command` [m/s, m/s, rad/s]: walk_command until another value is set.
  GaitClock(Setup& setup, const Vec3d& command);

  void initialize() noexcept;
  /// Advances by `dt` [s], the phase `rate` [1] times as fast as the period; `steps` steps on the spot where nothing else moves.
  void advance(double dt, const GaitLimits& limits, double rate = 1, bool steps = false) noexcept;
  /// Sets phase [rad] and amplitude [1] at once.
  void start_at(double phase, double amplitude) noexcept;

  /// Whether nothing moves and the command, within the limits, is zero.
  [[nodiscard]] bool is_idle(const GaitLimits& limits) const noexcept;
  [[nodiscard]] const Vec3d& velocity() const noexcept { return velocity_; }           ///< [m/s, m/s, rad/s]
  [[nodiscard]] double phase() const noexcept { return phase_; }                       ///< [rad] 0 to 2 pi
  [[nodiscard]] std::size_t standing() const noexcept { return phase_ < pi ? 0 : 1; }  ///< 0: left
  /// [1] of the step of that foot
  [[nodiscard]] double share() const noexcept { return (phase_ < pi ? phase_ : phase_ - pi) / pi; }
  [[nodiscard]] double amplitude() const noexcept { return amplitude_; }  ///< [1] 0 stands, 1 walks
  /// [m/s, m/s, rad/s] The command, or what replaces it, within the limits and without the trim; zero while halted.
  [[nodiscard]] Vec3d wanted(const GaitLimits& limits) const noexcept;

 private:
  const Vec3d& command_;
  const double& halted_;  // 1: a referee requests a halt
  Vec3d& velocity_;
  double& phase_;
  double& amplitude_;
};

}  // namespace murosimf::locomotion
