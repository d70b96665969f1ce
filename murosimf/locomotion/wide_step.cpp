#include "murosimf/locomotion/wide_step.h"

#include <algorithm>
#include <cmath>

#include "murosimf/math/assert.h"

namespace murosimf::locomotion {

KeyframeMotion wide_step(const std::array<Leg, 2>& legs, const WalkParameters& walk, std::size_t side) {
  MUROSIMF_ASSERT(side < 2);
  constexpr double sinks = 0.3, reach = 0.95, lean = 0.6;     // [1] of the hips' height, [1] of the leg, [rad]
  constexpr double aside = 0.3, waits = 0.5, together = 0.4;  // [s]
  const Leg& leg = legs[side];
  const double hips = walk.hip_height - leg.ankle_height, down = sinks * hips, low = hips - down;
  const double longest = reach * (leg.thigh + leg.shin);
  const double leans = std::min(std::sqrt(std::max(0.0, longest * longest - low * low)), low * std::tan(lean));
  const double w = (side == 0 ? 1 : -1) * leans;
  const std::string leads = side == 0 ? "left_foot" : "right_foot", follows = side == 0 ? "right_foot" : "left_foot";
  KeyframeMotion motion{.name = "wide_step",
                        .columns = {{{leads + ".y"}}, {{leads + ".z"}}, {{follows + ".y"}}, {{follows + ".z"}}},
                        .start = {0, 0, 0, 0}};
  motion.frames = {{aside / 2, {w, walk.lift + down / 2, 0, down / 2}},
                   {aside / 2, {w, down, -w, down}},
                   {waits, {w, down, -w, down}},
                   {together / 2, {w / 2, down / 2, -w / 2, walk.lift + down / 2}},
                   {together / 2, {0, 0, 0, 0}}};
  MUROSIMF_ASSERT(duration(motion) > 0);
  return motion;
}

}  // namespace murosimf::locomotion
