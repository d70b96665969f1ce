/// keyframe_motion.h - a motion given by key frames: joint angles and places of feet at certain times. Data only.
///
/// From one key frame to the next every value runs along a cosine, at rest at both ends:
///     x(t) = a + (b - a) (1 - cos(pi s)) / 2      s = time since the frame before / duration of this one
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "murosimf/math/vec3.h"

namespace murosimf::locomotion {

/// A joint or an axis of a foot that a value of a key frame sets.
struct Channel {
  std::string name;  ///< a joint [rad | m], or "left_foot.x", ".y", ".z" [m], ".pitch" [rad]; the same for "right_foot"
  double sign = 1;   ///< -1: the value counts in the opposite direction
};

struct KeyFrame {
  double duration = 0;         ///< [s] from the frame before, positive
  std::vector<double> values;  ///< one per column
};

/// Of a motion that kicks a ball: where the ball lies and goes, seen from the base as the robot stands before the motion; x forward, y to
/// the left. The foot that kicks is on the side on which the ball lies.
struct Kick {
  Vec3d ball;            ///< [m] on the ground; z: 0
  double direction = 0;  ///< [rad] in which the ball leaves, to the left of forward
};

struct KeyframeMotion {
  std::string name;
  std::vector<std::vector<Channel>> columns;  ///< a value may set several channels: both arms
  std::vector<double> start;                  ///< values at the beginning, one per column
  std::vector<KeyFrame> frames;               ///< at least one
  bool other_side = false;                    ///< still to be mirrored: played_by (mirrored_motion.h)
  std::optional<Kick> kick{};                 ///< nothing: it is no kick
};

/// [s] from the start to the last key frame.
[[nodiscard]] double duration(const KeyframeMotion& motion) noexcept;

/// Writes the value of every column at `time` [s] after the start to `values`; before the start and after the end the first and
/// the last values hold.
void sample(const KeyframeMotion& motion, double time, std::span<double> values) noexcept;

}  // namespace murosimf::locomotion
