/// gait_limits.h - limits a walk to what the legs reach and the joints can follow.
#pragma once

#include <functional>

#include "murosimf/locomotion/gait.h"

namespace murosimf::locomotion {

/// Where legs turn farther outward than inward, or the other way round, and do not reach the fastest turn on the spot therefore, the least
/// splay with which they do; none if they reach it with none.
void fit_splay(const std::array<Leg, 2>& legs, WalkParameters& parameters);

/// Where the legs do not reach the ends of the strides at full speed (ranges or offsets of the hinges), hips are lowered, by up to 11 %,
/// and strides made shorter until they do.
void fit_to_reach(const std::array<Leg, 2>& legs, WalkParameters& parameters);

/// Keeps joints below 0.9 of their largest rate (joint_rate_limit) as far as possible: feet are lifted less, down to a third,
/// then steps take longer, up to half as long again, until 0.6 of the speed is left; then strides get shorter. `sway` is the one of a period.
void fit_to_rates(const Model& model, const std::array<Leg, 2>& legs,
                  const std::function<double(const WalkParameters&)>& sway, WalkParameters& parameters);

}  // namespace murosimf::locomotion
