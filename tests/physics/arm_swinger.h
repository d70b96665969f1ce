/// arm_swinger.h - algorithm: kid21 stands on both legs and swings arms and waist.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "murosimf/locomotion/gait_seed.h"
#include "murosimf/model/properties.h"
#include "murosimf/world/algorithm.h"
#include "murosimf/world/setup.h"

namespace murosimf::test {

/// Amplitude 1 is 0.3 rad, at 1 Hz.
class ArmSwinger final : public Algorithm {
 public:
  ArmSwinger(Setup& setup, double amplitude)
      : model_(setup.model()), amplitude_(amplitude), target_(setup.write(properties::joint_target)) {}
  [[nodiscard]] Phase phase() const noexcept override { return Phase::control; }
  void initialize() override {
    std::fill(target_.begin(), target_.end(), 0.0);
    const auto legs = locomotion::find_legs(model_);
    const auto pose = locomotion::gait_pose(legs, locomotion::seeded_parameters(legs), 0, 0, {});
    for (std::size_t side = 0; side < 2; ++side) {
      for (std::size_t i = 0; i < legs[side].joints.size(); ++i) target_[legs[side].joints[i]] = pose.q[side][i];
    }
  }
  void step(const Instant& instant) noexcept override {
    const double s = std::sin(2 * pi * seconds(instant.now));
    target_[model_.object_index("l_sh_pitch")] = 0.3 * amplitude_ * s;
    target_[model_.object_index("r_sh_pitch")] = -0.3 * amplitude_ * s;
    target_[model_.object_index("j_torso")] = 0.3 * amplitude_ * s;
  }

 private:
  const Model& model_;
  double amplitude_;
  std::span<double> target_;
};

}  // namespace murosimf::test
