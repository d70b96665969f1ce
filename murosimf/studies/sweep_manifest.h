/// sweep_manifest.h - an experiment as a file: all runs of a sweep, which any number of processes on any machines do in shards.
///
///     write_manifest("push.json", options);                        // runs nothing
///     run_shard(read_manifest("push.json"), {3, 8}, common);       // in any process; notes its runs in push.runs/3_of_8.txt
///     to_text(merged(read_manifest("push.json")));                 // of what is done
///
/// A shard's file is locked by the process that works on it; the lock ends with the process, however that ends. So, of shards of one n,
/// a run is in progress in one process at most, one that was killed is repeated, and the table follows from the manifest and the
/// finished runs alone.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "murosimf/studies/sweep.h"

namespace murosimf::studies {

struct SweepManifest {
  std::filesystem::path file;
  /// Scene, axes, seeds, duration and changes; `scene` leads to its file from the present working folder, and `common` lacks threads, plug-ins and
  /// permissions.
  SweepOptions options;
  std::vector<std::string> results;                    ///< names, with unit
  std::string description;                             ///< SweepPlan::description
  [[nodiscard]] std::filesystem::path folder() const;  ///< of finished runs
};

/// Files of the scene are named from the manifest's folder on. Throws SetupError as sweep(); the file is there already, and is another
/// experiment's.
void write_manifest(const std::filesystem::path& file, const SweepOptions& options);

/// Throws SetupError: it is no manifest, or was changed since it was written.
[[nodiscard]] SweepManifest read_manifest(const std::filesystem::path& file);

/// What the manifest does not say of its runs.
struct ShardOptions {
  scene::SceneOptions common{};  ///< `threads`, `libraries` and `stop` are used
  std::string program{};         ///< as SweepOptions has it
  std::function<void(std::size_t done, std::size_t all)> progress{};
  std::function<void(const std::string& writer)> waits{};  ///< another process works on this shard; called once
};

/// Does the missing runs of a shard; waits while another process works on this shard, as one whose parent was killed does.
/// Of "any", all shards in turn that no process works on. The result has what others have done, too. Throws SetupError: files that the scene reads
/// are not those of the manifest, or as sweep().
[[nodiscard]] Sweep run_shard(const SweepManifest& manifest, const Shard& shard, const ShardOptions& options);

/// What is done, of all shards. Reads the manifest and finished runs, and no scene. Throws SetupError: a file in the folder belongs to another
/// manifest.
[[nodiscard]] Sweep merged(const SweepManifest& manifest);

}  // namespace murosimf::studies
