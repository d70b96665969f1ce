/// named_motions.h - the motions of a robot, by their purpose: "kick_right", "get_up_front", "dive_left".
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/locomotion/keyframe_motion.h"

namespace murosimf::locomotion {

struct NamedMotion {
  std::string name;
  KeyframeMotion motion;  ///< as the model plays it: mirrored already
};

/// In the order of their names.
using NamedMotions = std::vector<NamedMotion>;

/// Null if there is none of that name.
[[nodiscard]] inline const KeyframeMotion* motion_named(const NamedMotions& motions, std::string_view name) {
  const auto found = std::ranges::find(motions, name, &NamedMotion::name);
  return found == motions.end() ? nullptr : &found->motion;
}

/// Whether one of them kicks a ball.
[[nodiscard]] inline bool has_kick(const NamedMotions& motions) {
  return std::ranges::any_of(motions, [](const NamedMotion& one) { return one.motion.kick.has_value(); });
}

}  // namespace murosimf::locomotion
