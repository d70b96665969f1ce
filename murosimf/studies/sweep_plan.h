/// sweep_plan.h - what a sweep will run and what its results are called, found out before any run, and a description that tells
/// sweeps apart.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "murosimf/studies/sweep.h"

namespace murosimf::studies {

struct SweepPlan {
  std::vector<std::string> patterns;  ///< of results (chosen_results.h)
  std::vector<std::uint64_t> seeds;
  std::vector<GridPoint> points;     ///< of all runs
  std::vector<std::string> results;  ///< names, with unit
  Duration duration{};
  std::shared_ptr<scene::Assets> assets;  ///< loaded on the way; null: none
  /// One line of JSON: program, scene, changes, axes, seeds, results, and each file that any run reads, with a hash of its contents.
  /// Sweeps of equal descriptions have equal runs.
  std::string description;
};

/// Builds the scene, and steps nothing. Throws SetupError as sweep().
[[nodiscard]] SweepPlan plan_of(const SweepOptions& options);

/// How the scene of a run is built.
[[nodiscard]] scene::SceneOptions scene_options(const SweepOptions& sweep, const GridPoint& point);

}  // namespace murosimf::studies
