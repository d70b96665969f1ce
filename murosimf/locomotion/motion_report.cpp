#include "murosimf/locomotion/motion_report.h"

#include <algorithm>

#include "murosimf/math/assert.h"

namespace murosimf::locomotion {
namespace {

Activity activity_of(MotionMode mode, bool plays, bool dives, double amplitude) noexcept {
  switch (mode) {
      // No default: the compiler reports modes that are missing here.
    case MotionMode::walk: return amplitude > 0 ? Activity::walk : Activity::stand;
    case MotionMode::play: return dives ? Activity::dive : Activity::play;
    case MotionMode::protect: return plays ? Activity::protect : Activity::fall;
    case MotionMode::lie: return Activity::lie;
    case MotionMode::get_up: return Activity::get_up;
  }
  return Activity::stand;
}

}  // namespace

MotionReport motion_report(const NamedMotions& motions, const MotionState& state, const GaitState& gait,
                           double amplitude) noexcept {
  const auto mode = static_cast<MotionMode>(state.mode);
  const int motion = mode == MotionMode::walk ? -1 : static_cast<int>(state.motion);  // a waiting one is not played
  const bool plays = motion >= 0 && motion < static_cast<int>(motions.size());
  MUROSIMF_ASSERT(!plays || static_cast<std::size_t>(motion) < motions.size());
  MotionReport report{.motion = plays ? motion : -1};
  report.activity = activity_of(mode, plays, plays && motions[motion].name.starts_with("dive"), amplitude);
  if (plays && state.duration > 0) report.phase = std::clamp((state.time - state.blend) / state.duration, 0.0, 1.0);
  report.fallen = mode == MotionMode::lie || mode == MotionMode::get_up || gait.attitude.up.z < cos_fallen;
  return report;
}

}  // namespace murosimf::locomotion
