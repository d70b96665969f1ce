/// limb_swinger.h - algorithm: arms and legs of kid21 swing by 0.6 rad at 1 Hz, as joint targets.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "murosimf/model/properties.h"
#include "murosimf/world/algorithm.h"
#include "murosimf/world/setup.h"

namespace murosimf::test {

class LimbSwinger final : public Algorithm {
 public:
  /// `conical`: arms and legs move on cones, so that the body behind them turns a bit in every cycle.
  explicit LimbSwinger(Setup& setup, bool conical = false)
      : model_(setup.model()), conical_(conical), target_(setup.write(properties::joint_target)) {}

  [[nodiscard]] Phase phase() const noexcept override { return Phase::control; }
  void initialize() override { std::fill(target_.begin(), target_.end(), 0.0); }
  void step(const Instant& instant) noexcept override {
    const double phase = 2 * pi * seconds(instant.now);
    for (const char* name : {"l_sh_pitch", "r_sh_pitch", "l_thigh", "r_thigh"}) set(name, 0.6 * std::sin(phase));
    if (!conical_) return;
    for (const char* name : {"l_upper_arm", "r_upper_arm", "l_hip_roll", "r_hip_roll"}) {
      set(name, 0.3 * (1 - std::cos(phase)));
    }
  }

 private:
  void set(const char* name, double angle) noexcept { target_[model_.object_index(name)] = angle; }

  const Model& model_;
  bool conical_;
  std::span<double> target_;
};

}  // namespace murosimf::test
