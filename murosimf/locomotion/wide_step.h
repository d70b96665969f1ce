/// wide_step.h - a step to the side as wide as the legs allow: a block for a robot that cannot fall, instead of a dive.
///
/// The foot of that side goes outward while the hips sink, then the other one follows, and the robot ends upright, beside where it
/// stood. With l thigh and shin, h the hips above the ankles and s = 0.7 h when they have sunk, each leg leans outward by
///     w = min(sqrt((0.95 l)^2 - s^2), s tan 0.6)
/// and the step is 2 w wide.
/// Source: paper, Fig. 10, for what it is for.
#pragma once

#include "murosimf/locomotion/gait.h"
#include "murosimf/locomotion/keyframe_motion.h"

namespace murosimf::locomotion {

/// For KeyframeTargets, which places feet from the stance of `walk`. `side`: 0 left, 1 right.
[[nodiscard]] KeyframeMotion wide_step(const std::array<Leg, 2>& legs, const WalkParameters& walk, std::size_t side);

}  // namespace murosimf::locomotion
