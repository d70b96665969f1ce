/// walk_senses.h - state of a walking robot: attitude, center of mass and odometry from its inertial sensor and its encoders.
///
/// With R the rotation of roll and pitch from the attitude filter, c_a the center of mass from an ankle by forward kinematics of the
/// encoders, w the gyroscope, all in axes of the base, omega the rate of the pendulum:
///
///     xi = R c_a + R (w x c_a + dc_a/dt) / omega         dc_a/dt from differences, through a low-pass
///
/// w is the rate of the gyroscope less its bias, and less the rates of the joints between the base and the sensor's link (a waist),
/// which are differences of their encoders through the same low-pass.
/// Odometry: the ankle that stands does not move, and the heading is the integral of the vertical rate.
/// Source: gait_feedback.h.
#pragma once

#include <span>
#include <vector>

#include "murosimf/locomotion/gait_state.h"
#include "murosimf/locomotion/leg.h"
#include "murosimf/world/setup.h"

namespace murosimf::locomotion {

class WalkSenses {
 public:
  /// Throws SetupError if the robot has no sensor "imu" with gyroscope and accelerometer, or no sensors of the type joint_position for the
  /// joints of its legs and those that turn the inertial sensor against the base. Of two sensors of one joint, the first one counts.
  WalkSenses(Setup& setup, const std::array<Leg, 2>& legs);

  /// Resets the state before the first control cycle.
  void initialize(std::size_t standing, GaitState& state) noexcept;
  struct Numbers {
    double smoothing = 0;   ///< [s] of the low-pass
    double omega = 0;       ///< [1/s]
    double still_rate = 0;  ///< [rad/s] of a robot that stands
  };
  /// Updates the state after a control cycle of `dt` [s], in which `standing` (0: left) stood.
  void follow(double dt, std::size_t standing, const Numbers& numbers, GaitState& state) noexcept;
  /// Makes `standing` the foot that stands.
  void change_foot(std::size_t standing, GaitState& state) const noexcept;

  /// [rad] Pitch of that foot's sole against the level, its toe below its heel: above 0.
  [[nodiscard]] double sole_pitch(std::size_t side, const GaitState& state) const noexcept;
  /// [rad | m] of all objects, as measured.
  [[nodiscard]] std::span<const double> joints() const noexcept { return q_; }
  [[nodiscard]] const Vec3d& odometry() const noexcept { return odometry_; }  ///< [m, m, rad]
  [[nodiscard]] const Vec3d& rate() const noexcept { return rate_; }  ///< [rad/s] gyroscope less bias, axes of the base

 private:
  /// Source of a joint's position.
  struct Encoder {
    const double* value = nullptr;
    int joint = 0;
  };

  void find_encoders(Setup& setup);
  void require(int joint) const;
  void read_joints() noexcept;
  [[nodiscard]] Vec3d waist_rate(double dt, double smoothing, GaitState& state) noexcept;
  [[nodiscard]] Vec3d flat_step(std::size_t standing, const GaitState& state) const noexcept;

  const std::array<Leg, 2>& legs_;
  const Model& model_;
  std::vector<Encoder> encoders_;
  std::span<const double> gyroscope_, accelerometer_;  // [rad/s], [m/s^2] axes of the sensor
  int mounting_ = 0;                                   // object of the link that the sensor is on
  std::vector<Link> waist_;                            // hinges between the base and it
  Mat3d turn_;                                         // axes of the sensor to those of that link
  double gravity_ = 9.81;                              // [m/s^2]
  std::vector<double> q_;
  std::vector<Vec3d> r_, rest_;  // of all objects, in the base
  std::vector<Mat3d> R_;
  Vec3d rate_;
  Vec3d& odometry_;
};

/// Roll and pitch of a base, from its axes to level ones with its heading.
[[nodiscard]] Mat3d level_axes(const AttitudeFilter& attitude) noexcept;

}  // namespace murosimf::locomotion
