// `murosimf sweep MANIFEST`: all runs of an experiment, a shard of them, or the tables of what is done.
#include <utility>

#include <fmt/format.h>

#include "apps/interruption.h"
#include "apps/progress.h"
#include "apps/record_options.h"
#include "apps/standard_output.h"
#include "apps/sweep_arguments.h"
#include "murosimf/model/error.h"
#include "murosimf/studies/sweep_manifest.h"

namespace murosimf::app {
namespace {

constexpr int incomplete = 1;

/// What the manifest says cannot be said again.
void refuse_options(const SweepArguments& arguments) {
  const SceneArguments& scene = arguments.runs.scene;
  const std::pair<const char*, bool> options[] = {
      {"--seeds", !arguments.seeds.empty()},       {"--grid", !arguments.grid.empty()},
      {"--result", !arguments.results.empty()},    {"--runs", !arguments.noted.empty()},
      {"--manifest", !arguments.manifest.empty()}, {"--duration", arguments.runs.duration.has_value()},
      {"--set", !scene.overrides.empty()},         {"--at", !scene.events.empty()},
      {"--push", !scene.pushes.empty()},           {"--lenient", scene.lenient},
      {"--no-cameras", arguments.runs.no_cameras}};
  for (const auto& [name, is_given] : options) {
    if (is_given) throw SetupError(fmt::format("{}: it is part of the manifest '{}'", name, scene.file));
  }
  if (arguments.merge && !arguments.shard.empty()) throw SetupError("--merge: it is of all shards; leave --shard out");
  const bool has_tables = !arguments.csv.empty() || !arguments.summary.empty() || !arguments.runs.json.empty();
  if (!arguments.shard.empty() && has_tables) {
    throw SetupError("--shard: it is a part of the experiment; its tables are made by --merge, of all shards");
  }
}

studies::Sweep run(const studies::SweepManifest& manifest, const SweepArguments& arguments) {
  studies::ShardOptions options{.common = options_of(arguments.runs), .program = this_program()};
  end_gently();
  Progress progress;
  options.progress = [&](std::size_t done, std::size_t all) {
    progress.show(static_cast<double>(done) / static_cast<double>(all), fmt::format("{} of {} runs", done, all));
  };
  options.waits = [&](const std::string& writer) {
    say_note(fmt::format("{} works on this shard: waiting for it", writer));
  };
  const studies::Shard shard = arguments.shard.empty() ? studies::Shard{} : studies::parse_shard(arguments.shard);
  return studies::run_shard(manifest, shard, options);
}

/// What a shard prints in the place of a table, which would be one of a part.
std::string state_of(const studies::Sweep& result, const std::string& shard) {
  const std::size_t missing = missing_runs(result);
  return fmt::format("shard {}: {} of all {} runs are done, {} are missing\n", shard, result.runs.size() - missing,
                     result.runs.size(), missing);
}

}  // namespace

int sweep_manifest(const SweepArguments& arguments) {
  refuse_options(arguments);
  claim_tables(arguments);
  const studies::SweepManifest manifest = studies::read_manifest(arguments.runs.scene.file);
  const studies::Sweep result = arguments.merge ? studies::merged(manifest) : run(manifest, arguments);
  Results results;
  if (arguments.shard.empty()) {
    if (result.taken_over > 0) say_note(fmt::format("{} runs were done already", result.taken_over));
    write_tables(results, arguments, result);
  } else {
    results.write([&] { write_standard_output(state_of(result, arguments.shard)); });
  }
  if (!result.not_noted.empty()) results.write([&] { throw SetupError(result.not_noted); });
  if (result.stopped) say_error(fmt::format("stopped by {}; runs that had not ended are missing", signal_name()));
  if (!arguments.merge) return results.exit_code(result.stopped ? exit_code() : 0);
  const std::size_t missing = missing_runs(result);
  if (missing > 0) say_error(fmt::format("{} of {} runs are missing", missing, result.runs.size()));
  return results.exit_code(missing > 0 ? incomplete : 0);
}

}  // namespace murosimf::app
