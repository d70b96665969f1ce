/// recorded_run.h - a recording as a run that can be repeated, from the file alone: the scene is built anew from the files that are
/// attached to it, goes on from any of its states, and gets the commands that came.
///
///     const RecordedRun run("game.mcap");
///     const auto scene = run.build({});
///     run.begin(*scene, 12s);                               // at the last state that is recorded until then
///     scene->simulation().run(12s - scene->simulation().now());
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/recording/recorded_states.h"
#include "murosimf/recording/run_description.h"
#include "murosimf/recording/unpacked_files.h"
#include "murosimf/runtime/external_input_log.h"
#include "murosimf/scene/scene.h"

namespace murosimf::recording {

/// How a run is built again; none of it changes a result.
struct RepeatOptions {
  int threads = 1;
  bool lanes = true;
  bool libraries = false;  ///< control software that the scene names may be loaded, if it was allowed to then
  std::optional<bool> cameras{};
  bool recorded = false;                 ///< the repetition is recorded itself
  std::vector<std::string> overrides{};  ///< besides those of the run: of what is only looked at
  StopRequest stop{};
};

class RecordedRun {
 public:
  /// Throws SetupError: no recording, or not one that says how it was begun.
  explicit RecordedRun(const std::filesystem::path& file);

  [[nodiscard]] const McapReader& file() const { return file_; }
  [[nodiscard]] const RunDescription& description() const { return description_; }
  [[nodiscard]] Duration end() const { return end_; }
  [[nodiscard]] const RecordedStates& states() const { return states_; }

  /// Throws SetupError: a file is missing or has changed that was too large for the recording; the run needs what cannot be repeated.
  /// What came from outside comes again, from the recording.
  [[nodiscard]] std::shared_ptr<scene::Scene> build(const RepeatOptions& options) const;
  /// For who shows what was recorded, and makes no steps: of every run, whatever took part in it. Only `threads` and `stop` count.
  [[nodiscard]] std::unique_ptr<scene::Scene> build_to_show(const RepeatOptions& options) const;
  /// With its files, unlike Simulation::initialize().
  void initialize(scene::Scene& scene) const;
  /// Initializes, goes to the last whole state until `time`, or to the start, and has the commands from then on carried out when
  /// their time comes. Without `states` to the first one: where the run began.
  void begin(scene::Scene& scene, Duration time, bool states = true) const;

 private:
  void check_repeatable(const scene::Scene& scene) const;

  McapReader file_;
  RunDescription description_;
  UnpackedFiles files_;
  RecordedStates states_;
  std::shared_ptr<const ExternalInputLog> outside_;  // null: nobody else took part
  Duration end_{};
};

}  // namespace murosimf::recording
