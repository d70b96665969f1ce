/// keyframe_motion.h - a motion told by key frames: joint angles and places of feet at certain times. Data only.
///
/// From one key frame to the next every value runs along a cosine, at rest at both ends:
///     x(t) = a + (b - a) (1 - cos(pi s)) / 2      s = time since the frame before / duration of this one
#pragma once

#include <span>
#include <string>
#include <vector>

namespace murosimf::locomotion {

/// What a value of a key frame sets.
struct Channel {
  std::string name;  ///< a joint [rad | m], or "left_foot.x", ".y", ".z" [m], ".pitch" [rad]; the same for "right_foot"
  double sign = 1;   ///< -1: the value counts the other way
};

struct KeyFrame {
  double duration = 0;         ///< [s] from the frame before, positive
  std::vector<double> values;  ///< one per column
};

struct KeyframeMotion {
  std::string name;
  std::vector<std::vector<Channel>> columns;  ///< a value may set several channels: both arms
  std::vector<double> start;                  ///< values at the beginning, one per column
  std::vector<KeyFrame> frames;               ///< at least one
  bool other_side = false;                    ///< still to be mirrored: played_by (mirrored_motion.h)
};

/// [s] from the start to the last key frame.
[[nodiscard]] double duration(const KeyframeMotion& motion) noexcept;

/// Writes the value of every column at `time` [s] after the start to `values`; before the start and after the end those stand
/// that are there.
void sample(const KeyframeMotion& motion, double time, std::span<double> values) noexcept;

}  // namespace murosimf::locomotion
