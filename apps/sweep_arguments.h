/// sweep_arguments.h - the command `sweep`: its options, its tables, and what it does with a manifest.
#pragma once

#include <string>
#include <vector>

#include "apps/results.h"
#include "apps/series_arguments.h"
#include "murosimf/studies/sweep.h"

namespace murosimf::app {

struct SweepArguments {
  SeriesArguments runs;
  std::string seeds;
  std::vector<std::string> grid, results;
  std::string noted, csv, summary;  ///< files
  std::string manifest;             ///< file to be written
  std::string shard;                ///< "3/8"
  bool merge = false;
};

inline constexpr const char* manifest_ending = ".json";

/// Whether a manifest is in the place of the scene.
[[nodiscard]] bool is_manifest(const SweepArguments& arguments);
/// Runs a manifest, a shard of it, or merges what is done. Returns the exit code. Throws SetupError.
[[nodiscard]] int sweep_manifest(const SweepArguments& arguments);

/// To be called before the first run. Throws SetupError.
void claim_tables(const SweepArguments& arguments);
/// On standard output and into the files that were asked for.
void write_tables(Results& results, const SweepArguments& arguments, const studies::Sweep& sweep);

}  // namespace murosimf::app
