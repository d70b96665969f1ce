/// joint_trajectory.h - joint angles over time, recorded or computed. Data only.
///
/// Each joint has its own times. Between two of them the angle is interpolated linearly or held; before the first and after the last
/// time it is constant.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace murosimf::control_software {

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

/// Value [rad | m] at `time` [s]. At a time of the table it equals the table's value bit for bit.
[[nodiscard]] double value_at(const JointTrajectory::Joint& joint, double time, Between between) noexcept;

/// Period [s] after which a motion that repeats from `begin` [s] restarts: a last row that equals the one at `begin` is the same
/// instant; else the first row comes one spacing after the last. 0 if nothing comes after `begin`.
[[nodiscard]] double loop_period(const JointTrajectory& trajectory, double begin) noexcept;

}  // namespace murosimf::control_software
