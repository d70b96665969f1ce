/// ankle_strategy.h - algorithm: stands and balances pushes from the front and the back by its ankles, from an inertial sensor alone.
///
/// A complementary filter follows up. With w the gyroscope less its bias, f the accelerometer, both in axes of the
/// sensor (x forward, y left, z up), u the unit vector upward:
///
///     u' = u x w + (f/|f| - u)/T                                 T: `trust_time`
///
/// Bias and the upright u_0 are means over the first `settle_time`, in which the robot must stand undisturbed: that removes
/// errors of the sensor and of its mounting. Ankles respond to where a pendulum of height z that leans like the robot would
/// come to rest (the capture point, as an angle), smoothed:
///
///     lean = atan2(-u_x, u_z) - that of u_0                      [rad] forward
///     xi' = (lean + w_y/sqrt(g/z) - xi)/T_s                      [rad] T_s: `smooth_time`
///     sole = a xi, up to a limit                                 [rad] toes down
///
/// Below 0.1 m/s^2 of gravity nothing leans, and noise of the gyroscope over a small sqrt(g/z) would move the feet: the soles stay level.
///
/// Feet press with their toes or heels only, which those of a stiff robot do as well. So the gain is small: on
/// kid21 6 % of the largest push in the back and 4 % from the front; larger pushes need steps. Pushes from the side are
/// not balanced. Gains were chosen on kid21, which begins to rock between 0.7 and 1 (articulated_dynamics).
/// Source: filter: Mahony, Hamel, Pflimlin, Nonlinear Complementary Filters on the Special Orthogonal Group, IEEE TAC 53
/// (2008), explicit form for one vector. Capture point and ankles: Stephens, Humanoid Push Recovery, IEEE-RAS Humanoids
/// 2007; in people: Horak, Nashner, Central programming of postural movements, J Neurophysiol 55 (1986).
#pragma once

#include <array>
#include <vector>

#include "murosimf/locomotion/gait_seed.h"
#include "murosimf/model/properties.h"
#include "murosimf/world/algorithm.h"
#include "murosimf/world/setup.h"

namespace murosimf::locomotion {

struct AnkleStrategyOptions {
  double settle_time = 0.5;   ///< [s]
  double trust_time = 2;      ///< [s] T
  double smooth_time = 0.02;  ///< [s] T_s
  double gain = 0.5;          ///< [1] a
  double limit = 0.4;         ///< [rad] of the soles
};

class AnkleStrategy final : public Algorithm {
 public:
  /// Throws SetupError if the robot has no sensor "imu" with gyroscope and accelerometer, or no two legs.
  explicit AnkleStrategy(Setup& setup, const AnkleStrategyOptions& options = {});

  [[nodiscard]] Phase phase() const noexcept override { return Phase::control; }
  void initialize() override;
  void step(const Instant& instant) noexcept override;

  static constexpr double rate_hz = 200;

 private:
  void settle(double share) noexcept;
  void follow_up(double period) noexcept;
  void balance(double period) noexcept;
  void write_targets() noexcept;

  AnkleStrategyOptions options_;
  std::array<Leg, 2> legs_;
  WalkParameters stance_;
  double fall_rate_;                                   // [1/s] sqrt(g/z); 0: next to no gravity
  std::span<const double> gyroscope_, accelerometer_;  // [rad/s], [m/s^2]
  Vec3d &up_, &upright_, &bias_;                       // u, u_0 [1]; [rad/s]
  double& capture_;                                    // xi [rad]
  std::vector<double> rest_;                           // [rad | m] by object
  std::span<double> target_;                           // [rad] by object
};

}  // namespace murosimf::locomotion
