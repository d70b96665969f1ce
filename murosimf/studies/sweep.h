/// sweep.h - one scene, run for every combination of values and seeds; a table of chosen results.
///
///     studies::SweepOptions options{.scene = "walk", .axes = {studies::parse_axis("walker.command.0=0.1,0.2")},
///                                  .seeds = studies::parse_seeds("1..20")};
///     fmt::print("{}", to_text(studies::sweep(options)));
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/scene/scene.h"
#include "murosimf/studies/grid.h"
#include "murosimf/studies/shard.h"

namespace murosimf::studies {

struct SweepPlan;

struct SweepOptions {
  std::string scene;
  std::vector<GridAxis> axes{};
  std::vector<std::uint64_t> seeds{};  ///< none: the scene's
  std::optional<double> duration{};    ///< [s] instead of the scene's
  std::vector<std::string> results{};  ///< patterns (chosen_results.h); none: usual_results()
  scene::SceneOptions common{};        ///< of all runs; `threads`: runs at a time, each is stepped by one
  std::filesystem::path
      file{};             ///< where runs that are done are noted, so that a killed sweep can continue; empty: nowhere
  std::string program{};  ///< whose runs may be mixed: noted in the file
  std::string
      scene_name{};  ///< of the scene in files and tables, which do not depend on the working folder; empty: `scene`
  Shard shard{};     ///< runs of others are left to others
  std::filesystem::path
      others{};  ///< folder with such files of others (sweep_file.h): what is in them is taken over; empty: none
  std::function<void(const SweepPlan&)> check{};                      ///< before the first run; may throw SetupError
  std::function<void(std::size_t done, std::size_t all)> progress{};  ///< from any thread, one at a time
};

struct SweepRun {
  GridPoint point;
  std::vector<double> values;  ///< of the results; empty: it has not been done
};

struct Sweep {
  std::string scene;
  std::vector<std::string> axes;     ///< paths
  std::vector<std::string> results;  ///< names, with unit
  std::vector<SweepRun> runs;        ///< in the order of points_of()
  std::size_t taken_over = 0;        ///< runs of the shard that had been done already
  bool stopped = false;              ///< by common.stop
  std::string not_noted{};  ///< why runs are missing in `file`, which could not be written any more; empty: none are
};

/// Throws SetupError: a scene that cannot be built with one of the values, an unknown result, a file of another sweep.
[[nodiscard]] Sweep sweep(const SweepOptions& options);

/// Of which no run has been done.
[[nodiscard]] Sweep empty_sweep(const SweepOptions& options, const SweepPlan& plan);
/// How many have not been done, of all shards.
[[nodiscard]] std::size_t missing_runs(const Sweep& sweep);

// The same runs give the same bytes.

/// Text for users: a row for each combination of values, with mean and 95 % interval over the seeds.
[[nodiscard]] std::string to_text(const Sweep& sweep);
/// A row for each run.
[[nodiscard]] std::string to_csv(const Sweep& sweep);
/// Numbers only, so that they can be drawn: a row for each combination, with the values of axes that are numbers (without any: its
/// number), then mean and ends of the interval of each result.
[[nodiscard]] std::string summary_csv(const Sweep& sweep);
/// Runs and summary (docs/json.md).
[[nodiscard]] std::string to_json(const Sweep& sweep);

}  // namespace murosimf::studies
