/// saturation_watch.h - how long servos have been at a limit of their duty, current, torque or rate.
///
/// A servo at such a limit does not follow its target. In an articulated step the motor is at one if the line that it follows
/// (multibody/servo/torque_line.h) is not the free one. Counted for each joint, as a share of the time since the level began.
#pragma once

#include <span>
#include <string>

#include "murosimf/math/assert.h"
#include "murosimf/multibody/friction_solver.h"
#include "murosimf/world/entity.h"
#include "murosimf/world/setup.h"

namespace murosimf::dynamics {

class SaturationWatch {
 public:
  explicit SaturationWatch(Setup& setup);

  void initialize() noexcept;
  /// Counts a step of `dt` [s] > 0 in which the joints of these links, in their order, have moved.
  void look(const Tree& tree, std::span<const multibody::FrictionalJoint<double>> joints, double dt) noexcept;
  /// Adds a step of `dt` [s] to the observed time.
  void begin(double dt) noexcept {
    MUROSIMF_ASSERT(dt > 0);
    watched_ += dt;
  }
  /// Adds a step in which the servo of a joint (an object of the model) was at a limit.
  void add(int object, double dt) noexcept { saturated_[object] += dt; }

 private:
  std::span<double> saturated_;  // [s] by object
  double& watched_;              // [s]
};

/// One line about the servos that were at a limit for at least 1 % of the time: "blue1: servos give all they have: r_shin in 24 % of
/// the time, l_shin 23 %, l_thigh 3 %, r_thigh 3 % and 2 more". Empty if there are none, and at levels without servos.
[[nodiscard]] std::string saturation_message(const Entity& entity);

}  // namespace murosimf::dynamics
