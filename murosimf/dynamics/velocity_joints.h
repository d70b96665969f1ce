/// velocity_joints.h - joints that follow a rate (joint_velocity_target) instead of a position, such as wheels.
///
/// Hinges without ends turn for ever; their joint position is kept within a turn, so that sines stay exact.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "murosimf/math/assert.h"
#include "murosimf/world/setup.h"

namespace murosimf::dynamics {

class VelocityJoints {
 public:
  /// Takes the column of rate targets only if the model has such joints.
  explicit VelocityJoints(Setup& setup);

  /// Objects of the model, in its order; the second: all its other joints.
  [[nodiscard]] const std::vector<int>& joints() const { return joints_; }
  [[nodiscard]] const std::vector<int>& others() const { return others_; }
  [[nodiscard]] bool contains(int object) const { return turns_[static_cast<std::size_t>(object)]; }
  /// [rad/s | m/s] of one of joints(), held to its joint_target_range.
  [[nodiscard]] double target(int object) const noexcept {
    MUROSIMF_ASSERT(contains(object));
    const auto i = static_cast<std::size_t>(object);
    return std::clamp(target_[i], lowest_[i], highest_[i]);
  }
  /// Takes whole turns out of positions [rad] beyond half a turn.
  void wrap(std::span<double> q) const noexcept;

 private:
  std::vector<int> joints_, others_, endless_;
  std::vector<bool> turns_;               // by object
  std::vector<double> lowest_, highest_;  // [rad/s | m/s] that targets are held to, by object
  std::span<const double> target_;        // [rad/s | m/s] empty if there are none
};

}  // namespace murosimf::dynamics
