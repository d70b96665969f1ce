/// ankle_strategy.h - algorithm: stands, and answers pushes from the front and the back, from an inertial sensor alone.
///
/// Up is followed by a complementary filter. With w the gyroscope less its bias, f the accelerometer, both in axes of the
/// sensor (x forward, y left, z up), u the unit vector upward:
///
///     u' = u x w + (f/|f| - u)/T                                 T: `trust_time`
///     lean = atan2(-u_x, u_z) - that of u_0 - h                  [rad] of the legs, forward
///     lean' = w_y - h'                                           [rad/s]
///     h' = (hip - h)/T_h                                         T_h: `hip_time`
///
/// Bias and u_0 are means over the first `settle_time`, in which the robot must stand undisturbed: that removes errors of the
/// sensor and of its mounting. h is how far the hips have come: they turn the trunk with the sensor, which is no lean.
/// The answer is to where a pendulum of height z would come to rest, the capture point, as an angle. Ankles turn the
/// soles, and hips the trunk, each up to its limit:
///
///     xi' = (lean + lean'/sqrt(g/z) - xi)/T_s                    T_s: `smooth_time`
///     sole = a xi        hip = b xi                              [rad] toes down; trunk forward
///
/// Feet press against the lean, as far as they reach. A stiff robot's feet do that too, so ankles alone gain little (on kid21
/// 2 to 5 %); hips give what ankles cannot: while the trunk turns faster and faster with the fall, the ground pushes back harder than
/// the rims of the soles allow a stiff body.
/// Limits: to pushes from the side no more than standing stiffly; no steps. Gains were searched for on kid21.
/// Source: filter: Mahony, Hamel, Pflimlin, Nonlinear Complementary Filters on the Special Orthogonal Group, IEEE TAC 53
/// (2008), explicit form for one vector. Capture point and hips: Stephens, Humanoid Push Recovery, IEEE-RAS Humanoids 2007.
/// Ankles and hips of people: Horak, Nashner, Central programming of postural movements, J Neurophysiol 55 (1986).
#pragma once

#include <array>

#include "murosimf/control/gait.h"
#include "murosimf/model/algorithm.h"
#include "murosimf/model/properties.h"
#include "murosimf/model/setup.h"

namespace murosimf::control {

struct AnkleStrategyOptions {
  double settle_time = 0.5;                  ///< [s]
  double trust_time = 2;                     ///< [s] T
  double hip_time = 0.095;                   ///< [s] T_h, of the servos
  double smooth_time = 0.04;                 ///< [s] T_s
  double ankle = 1, hip = 2;                 ///< [1] a, b
  double most_ankle = 0.25, most_hip = 0.5;  ///< [rad] limits
};

class AnkleStrategy final : public Algorithm {
 public:
  /// Throws SetupError if the robot has no sensor "imu" with gyroscope and accelerometer, or no two legs.
  explicit AnkleStrategy(Setup& setup, const AnkleStrategyOptions& options = {});

  void initialize() override;
  void step(const Instant& instant) noexcept override;

  static constexpr double rate_hz = 200;

 private:
  void settle(double share) noexcept;
  void follow_up(double period) noexcept;
  void answer(double period) noexcept;
  void write_targets() noexcept;
  [[nodiscard]] double hip_target() const noexcept;

  AnkleStrategyOptions options_;
  std::array<Leg, 2> legs_;
  WalkParameters stance_;
  double fall_rate_;                                   // [1/s] sqrt(g/z)
  std::span<const double> gyroscope_, accelerometer_;  // [rad/s], [m/s^2]
  Vec3d &up_, &upright_, &bias_;                       // u, u_0 [1]; [rad/s]
  double &capture_, &hip_;                             // xi, h [rad]
  std::span<double> target_;                           // [rad] by object
};

}  // namespace murosimf::control
