#include "murosimf/studies/sweep_manifest.h"

#include <algorithm>
#include <chrono>
#include <system_error>
#include <thread>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "murosimf/files/file_lock.h"
#include "murosimf/files/input_file.h"
#include "murosimf/files/json_document.h"
#include "murosimf/files/output_file.h"
#include "murosimf/files/xml_element.h"
#include "murosimf/model/error.h"
#include "murosimf/recording/attached_files.h"
#include "murosimf/scene_file/scene_spec.h"
#include "murosimf/studies/sweep_file.h"
#include "murosimf/studies/sweep_plan.h"

namespace murosimf::studies {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::uintmax_t most_manifest_bytes = 1'000'000'000;

fs::path folder_of(const fs::path& file) { return fs::absolute(file).parent_path(); }

/// A scene's file from the manifest's folder on; names of supplied scenes stay.
std::string name_in_manifest(const std::string& scene, const fs::path& manifest) {
  std::error_code error;
  if (!fs::is_regular_file(scene, error)) return scene;
  return fs::absolute(scene).lexically_normal().lexically_proximate(folder_of(manifest).lexically_normal()).string();
}

std::string name_from_here(const std::string& scene, const fs::path& manifest) {
  std::error_code error;
  const fs::path file = folder_of(manifest) / scene;
  return fs::is_regular_file(file, error) ? file.string() : scene;
}

/// Seed and changes of each run, for other programs and for people.
json runs_of(const std::vector<GridAxis>& axes, const std::vector<GridPoint>& points) {
  json runs = json::array();
  for (const GridPoint& point : points) {
    json set = json::array();
    for (std::size_t i = 0; i < axes.size(); ++i) set.push_back(axes[i].path + "=" + point.values[i]);
    runs.push_back({{"seed", point.seed}, {"set", std::move(set)}});
  }
  return runs;
}

std::string document_of(const std::string& description, const json& runs) {
  return files::json_text({{"schema", files::json_schema("sweep_manifest")},
                           {"experiment", json::parse(description)},
                           {"fingerprint", recording::content_hash(description)},
                           {"runs", runs}});
}

/// Manifests may come from others.
void check_values(const SweepOptions& options) {
  const bool has_runs = !options.seeds.empty() &&
                        std::ranges::none_of(options.axes, [](const GridAxis& axis) { return axis.values.empty(); });
  if (!has_runs) throw SetupError("it has no runs: an axis without values, or no seeds");
  if (*options.duration < 0 || *options.duration > scene_file::longest_duration) {
    throw SetupError(fmt::format("duration_ns: must be from 0 to {} s", scene_file::longest_duration));
  }
}

SweepOptions options_in(const json& experiment) {
  SweepOptions options{.scene = experiment.at("scene"), .duration = {}, .results = experiment.at("patterns")};
  for (const json& axis : experiment.at("axes")) options.axes.push_back({axis.at("path"), axis.at("values")});
  experiment.at("seeds").get_to(options.seeds);
  options.duration = std::chrono::duration<double>(Duration(experiment.at("duration_ns").get<Duration::rep>())).count();
  experiment.at("set").get_to(options.common.overrides);
  experiment.at("at").get_to(options.common.events);
  experiment.at("push").get_to(options.common.pushes);
  experiment.at("lenient").get_to(options.common.lenient);
  experiment.at("cameras").get_to(options.common.cameras);
  experiment.at("program").get_to(options.program);
  check_values(options);
  return options;
}

SweepManifest parse(const fs::path& file, const std::string& text) {
  try {
    const json document = json::parse(text);
    if (document.at("schema") != files::json_schema("sweep_manifest")) {
      throw SetupError("it is no manifest of a sweep, or of another version of the program");
    }
    const json& experiment = document.at("experiment");
    SweepManifest manifest{.file = file, .options = options_in(experiment), .results = {}, .description = {}};
    manifest.description = experiment.dump(-1, ' ', false, json::error_handler_t::replace);
    experiment.at("results").get_to(manifest.results);
    const std::vector<GridPoint> points = points_of(manifest.options.axes, manifest.options.seeds);
    if (document_of(manifest.description, runs_of(manifest.options.axes, points)) != text) {
      throw SetupError("it was changed after it was written: its fingerprint or its runs do not belong to it");
    }
    manifest.options.scene_name = manifest.options.scene;
    manifest.options.scene = name_from_here(manifest.options.scene_name, file);
    return manifest;
  } catch (const json::exception&) {
    throw SetupError("it is no manifest of a sweep: 'sweep SCENE --manifest FILE' writes one");
  }
}

/// Which part of the description differs, for the message.
std::string difference(const json& was, const json& is) {
  for (const auto& [key, value] : was.items()) {
    if (is.contains(key) && is.at(key) == value) continue;
    if (key == "program") return fmt::format("it is of {}, and this is {}", value.dump(), is.value(key, json{}).dump());
    if (key != "files") return fmt::format("{} differ", key);
    const json& files = is.at(key);
    for (const auto& [file, hash] : value.items()) {
      if (!files.contains(file)) return fmt::format("file '{}' is not read now", file);
      if (files.at(file) != hash) return fmt::format("file '{}' has changed", file);
    }
    for (const auto& [file, hash] : files.items()) {
      if (!value.contains(file)) return fmt::format("file '{}' was not read then", file);
    }
  }
  return "it has been changed";
}

void check_fingerprint(const SweepManifest& manifest, const SweepPlan& plan) {
  if (plan.description == manifest.description) return;
  throw SetupError(files::one_line(
      fmt::format("{}: its runs would not belong together: {}; write another manifest", manifest.file.string(),
                  difference(json::parse(manifest.description), json::parse(plan.description)))));
}

fs::path file_of(const SweepManifest& manifest, const Shard& shard) {
  return manifest.folder() / fmt::format("{}_of_{}.txt", shard.number, shard.of);
}

SweepOptions options_of(const SweepManifest& manifest, const Shard& shard, const ShardOptions& given) {
  SweepOptions options = manifest.options;
  options.common.threads = given.common.threads;
  options.common.libraries = given.common.libraries;
  options.common.stop = given.common.stop;
  options.program = given.program;
  options.progress = given.progress;
  options.shard = shard;
  options.others = manifest.folder();
  options.file = file_of(manifest, shard);
  options.check = [&manifest](const SweepPlan& plan) { check_fingerprint(manifest, plan); };
  return options;
}

/// Of "any": shards in turn that no process works on.
Sweep run_free_shards(const SweepManifest& manifest, std::size_t count, const ShardOptions& given) {
  std::size_t taken_over = 0;
  Sweep result = merged(manifest);
  for (std::size_t k = 1; k <= count && !result.stopped; ++k) {
    const Shard shard{.number = k, .of = count};
    const bool has_missing = [&] {
      for (std::size_t i = k - 1; i < result.runs.size(); i += count) {
        if (result.runs[i].values.empty()) return true;
      }
      return false;
    }();
    if (!has_missing) continue;
    try {
      result = sweep(options_of(manifest, shard, given));
      taken_over += result.taken_over;
    } catch (const SweepFileBusy&) {  // by another process, which does its runs
    }
  }
  result.taken_over = taken_over;
  return result;
}

Sweep run_one_shard(const SweepManifest& manifest, const Shard& shard, const ShardOptions& given) {
  const SweepOptions options = options_of(manifest, shard, given);
  const auto stop = given.common.stop;
  for (bool waits = false;; waits = true) {
    try {
      return sweep(options);
    } catch (const SweepFileBusy&) {
      if (stop && stop()) throw;
      const std::string writer = files::who_writes(options.file);  // it may have ended just now
      if (!waits && !writer.empty() && given.waits) given.waits(writer);
      std::this_thread::sleep_for(std::chrono::milliseconds(200));
    }
  }
}

}  // namespace

fs::path SweepManifest::folder() const { return fs::path(file).replace_extension(".runs"); }

void write_manifest(const fs::path& file, const SweepOptions& given) {
  SweepOptions options = given;
  options.scene_name = name_in_manifest(options.scene, file);
  const SweepPlan plan = plan_of(options);
  const std::string text = document_of(plan.description, runs_of(options.axes, plan.points));
  std::error_code error;
  if (!fs::exists(file, error)) return files::write_file(file, text);
  if (files::read_input_file(file, most_manifest_bytes) == text) return;
  throw SetupError(files::one_line(
      fmt::format("{}: it is there, and not the manifest of this experiment; remove it, or name another file",
                  file.string())));
}

SweepManifest read_manifest(const fs::path& file) {
  const std::string text = files::read_input_file(file, most_manifest_bytes);
  return with_context(file.string(), [&] { return parse(file, text); });
}

Sweep run_shard(const SweepManifest& manifest, const Shard& shard, const ShardOptions& options) {
  std::error_code error;
  fs::create_directories(manifest.folder(), error);
  if (error) throw SetupError(fmt::format("cannot write '{}': {}", manifest.folder().string(), error.message()));
  return shard.number == 0 ? run_free_shards(manifest, shard.of, options) : run_one_shard(manifest, shard, options);
}

Sweep merged(const SweepManifest& manifest) {
  const SweepPlan plan{.patterns = manifest.options.results,
                       .seeds = manifest.options.seeds,
                       .points = points_of(manifest.options.axes, manifest.options.seeds),
                       .results = manifest.results,
                       .assets = {},
                       .description = manifest.description};
  Sweep result = empty_sweep(manifest.options, plan);
  for (auto& [run, values] : finished_runs(manifest.folder(), plan.description, plan.results.size())) {
    if (run < result.runs.size()) result.runs[run].values = values;
  }
  return result;
}

}  // namespace murosimf::studies
