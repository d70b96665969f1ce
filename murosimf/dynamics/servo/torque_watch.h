/// torque_watch.h - whether servos could provide the torques that a prescribed motion requires.
///
/// The need is smoothed by a first-order filter of 20 ms (peaks of a single step, when a foot lands, overload no servo)
/// and compared with the torque that the servo can give at that rate; the largest excess of every joint is kept.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "murosimf/dynamics/servo/servo_law.h"
#include "murosimf/world/algorithm.h"
#include "murosimf/world/entity.h"
#include "murosimf/world/setup.h"

namespace murosimf::dynamics {

class TorqueWatch {
 public:
  explicit TorqueWatch(Setup& setup);

  void initialize() noexcept;
  /// [N m | N] by object: properties::torque_need.
  [[nodiscard]] std::span<const double> need() const noexcept { return need_; }
  /// torque [N m | N], rate [rad/s | m/s] by object.
  void look(const Instant& instant, std::span<const double> torque, std::span<const double> rate) noexcept;

 private:
  struct Joint {
    int object = 0;
    std::unique_ptr<ServoLaw> law;
  };
  std::vector<Joint> joints_;  // those with a servo
  std::span<double> need_;
  std::span<Overload> overload_;
};

/// One line about the joint whose servo was too weak by the most, and the names of the others: "blue1: not feasible:
/// l_knee needs 9.1 Nm, servo gives 6.0 at 0.3 rad/s (at 3.21 s); also l_ankle". Empty if all were strong enough, and at levels
/// that do not watch.
[[nodiscard]] std::string overload_message(const Entity& entity);

/// Inertia [kg m^2 | kg] of the parts that turn behind a joint's gear: of its servo and of the joint itself.
[[nodiscard]] double rotor_inertia(const Model& model, int joint);

}  // namespace murosimf::dynamics
