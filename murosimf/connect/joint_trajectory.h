/// joint_trajectory.h - joint angles over time, as somebody has recorded or computed them. Data only.
///
/// Each joint has times of its own. Between two of them the angle runs along a straight line, or stands until the next; before the
/// first and after the last it stands.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace murosimf::connect {

struct JointTrajectory {
  struct Joint {
    int object = 0;                     ///< number in the model
    std::vector<double> times, values;  ///< [s] increasing, [rad | m]; at least one
  };
  std::vector<Joint> joints;
  double first = 0, last = 0;     ///< [s] of all times
  std::optional<double> spacing;  ///< [s] between two times, if it is the same everywhere
};

enum class Between {
  line,  ///< from one value to the next
  hold,  ///< the value that came last
};

/// Two times that are nearer than this [s] are the same one: clocks of files have rounded digits.
inline constexpr double same_time = 1e-7;

/// [rad | m] at `time` [s]. Whoever asks for a time of the table gets its value, to the last bit.
[[nodiscard]] double value_at(const JointTrajectory::Joint& joint, double time, Between between) noexcept;

/// [s] After which a motion that is repeated from `begin` [s] on begins again: a last row that repeats the one at `begin` is the same
/// instant; else the first row comes one spacing after the last. 0 if nothing comes after `begin`.
[[nodiscard]] double loop_period(const JointTrajectory& trajectory, double begin) noexcept;

}  // namespace murosimf::connect
