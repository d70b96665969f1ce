/// drive.h - algorithm: turns a desired speed and turning rate into rates of wheels and angles of steering.
///
/// The command is `walk_command` [m/s, m/s, rad/s]: speed of the middle of the unsteered axle, a sideways speed that a
/// car ignores, and the turning rate. With the curvature c = turning rate / speed of the path, a wheel with its
/// pivot at (x, y) from there rolls without slipping if
///
///     angle = atan2(c x, 1 - c y)      rate = speed (sqrt((1 - c y)^2 + (c x)^2) - c b) / radius
///
/// b: how far the wheel's middle is to the left of its pivot. The ends of the steering limit the curvature: the car then
/// keeps its speed and turns less. At speed 0 the wheels are held and the steering stays.
/// Source: Ackermann's condition, that the axles of all wheels meet in one point; any textbook of vehicle dynamics.
#pragma once

#include <vector>

#include "murosimf/locomotion/vehicle.h"
#include "murosimf/model/properties.h"
#include "murosimf/world/algorithm.h"
#include "murosimf/world/setup.h"

namespace murosimf::locomotion {

struct DriveOptions {
  double acceleration = 3;  ///< [m/s^2] a third of what tires on carpet can transmit; assumption
  double steering = 4;      ///< [1/(m s)] change of curvature: 0.3 s from straight to the end with models/car.xml
};

class Drive final : public Algorithm {
 public:
  /// `command` [m/s, m/s, rad/s]: walk_command until another value is set. Throws SetupError if the model has no driven
  /// wheel (vehicle.h).
  explicit Drive(Setup& setup, const Vec3d& command = {}, const DriveOptions& options = {});

  [[nodiscard]] Phase phase() const noexcept override { return Phase::control; }
  void initialize() override;
  void step(const Instant& instant) noexcept override;

  static constexpr double rate_hz = 100;

 private:
  void advance(double dt) noexcept;
  void write_targets() noexcept;

  Vehicle vehicle_;
  DriveOptions options_;
  const Vec3d& command_;           // [m/s, m/s, rad/s]
  const double& halted_;           // 1: a referee requests a halt
  Vec3d& velocity_;                // [m/s, m/s, rad/s] after the slew limits
  double& curvature_;              // [1/m]
  std::vector<double> rest_;       // [rad | m] by object
  std::span<double> target_;       // [rad] by object
  std::span<double> rate_target_;  // [rad/s] by object
};

}  // namespace murosimf::locomotion
