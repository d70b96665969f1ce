/// walk_tuning.h - numbers of a walk for one robot, searched by walking: lift, hip_roll and period around what is worked out for it.
///
///     const series::WalkTuning tuned = series::tune_walk({.model = "robot.urdf"});
///     fmt::print("{}{}", to_text(tuned), to_toml(tuned));
///
/// Every combination of 3 values each walks forward alone on the plane (scene `walk`), at every level asked for. The best one falls at
/// the fewest levels; of those, the mean over the levels of |forward / (speed time) - 1| + |sideways| / (speed time) is the smallest.
/// The same robot gives the same numbers for any number of threads.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "murosimf/locomotion/gait.h"
#include "murosimf/scene/scene.h"

namespace murosimf::series {

struct WalkTuningOptions {
  std::string model;  ///< as in scenes: a file, or the name of one that comes with the program
  std::vector<std::string> levels{"simplified_dynamics", "full_dynamics", "articulated_dynamics"};
  double speed = 0.1;            ///< [m/s] forward
  double duration = 10;          ///< [s] of each walk
  scene::SceneOptions common{};  ///< of all walks; `threads`: walks at a time, each is stepped by one
  std::function<void(std::size_t done, std::size_t all)> progress{};  ///< from any thread, one at a time
};

/// One combination of numbers, and how it walked at each level.
struct WalkTrial {
  double lift = 0, hip_roll = 0, period = 0;  ///< [m], [rad], [s]
  std::vector<double> falls;                  ///< [1] by level
  std::vector<double> forward, sideways;      ///< [m] by level
  int failed = 0;                             ///< levels at which it fell
  double miss = 0;                            ///< [1] the mean from above
};

struct WalkTuning {
  std::vector<std::string> levels;
  std::vector<WalkTrial> trials;  ///< best first
  bool stopped = false;           ///< by common.stop: some are missing
};

/// Throws SetupError: a robot that cannot be read or has no legs to walk with, or an unknown level.
[[nodiscard]] WalkTuning tune_walk(const WalkTuningOptions& options);

/// For people: the best ten.
[[nodiscard]] std::string to_text(const WalkTuning& tuning);
/// Section [walk] of the TOML file beside the robot, with the best.
[[nodiscard]] std::string to_toml(const WalkTuning& tuning);

}  // namespace murosimf::series
