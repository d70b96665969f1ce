/// recorded_run.h - a recording as a run that can be repeated from the file alone: the scene is rebuilt from the attached
/// files, continues from any recorded state, and gets the recorded commands.
///
///     const RecordedRun run("game.mcap");
///     const auto scene = run.build({});
///     run.begin(*scene, 12s);                               // at the last recorded state until then
///     scene->simulation().run(12s - scene->simulation().now());
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/files/file_access.h"
#include "murosimf/files/moved_files.h"
#include "murosimf/recording/recorded_addition.h"
#include "murosimf/recording/recorded_states.h"
#include "murosimf/recording/run_description.h"
#include "murosimf/recording/unpacked_files.h"
#include "murosimf/runtime/external_input_log.h"
#include "murosimf/scene/scene.h"

namespace murosimf::recording {

/// Options for rebuilding a run; none of them changes a result.
struct RepeatOptions {
  int threads = 1;
  bool lanes = true;
  bool libraries = false;  ///< control software of the scene may be loaded, if that was permitted in the run
  std::optional<bool> cameras{};
  bool recorded = false;                 ///< whether the repetition is recorded
  std::vector<std::string> overrides{};  ///< in addition to those of the run: for display only
  StopRequest stop{};
};

class RecordedRun {
 public:
  /// Throws SetupError: no recording, or one without a description of its run.
  explicit RecordedRun(const std::filesystem::path& file);

  [[nodiscard]] const McapReader& file() const { return file_; }
  [[nodiscard]] const RunDescription& description() const { return description_; }
  [[nodiscard]] Duration end() const { return end_; }
  [[nodiscard]] const RecordedStates& states() const { return states_; }
  /// Robots and bodies that came to it, in their order.
  [[nodiscard]] const std::vector<RecordedAddition>& additions() const { return additions_; }

  /// For readers of files that its scene names.
  [[nodiscard]] files::FileAccess access() const { return {.moved = moved_}; }

  /// Throws SetupError: a file is missing or has changed that was too large for the recording; the run cannot be repeated.
  /// External input is repeated from the recording.
  [[nodiscard]] std::shared_ptr<scene::Scene> build(const RepeatOptions& options) const;
  /// For display without steps: works for every run with any participants. Only `threads` and `stop` apply.
  [[nodiscard]] std::unique_ptr<scene::Scene> build_to_show(const RepeatOptions& options) const;
  /// Initializes with the recorded files, unlike Simulation::initialize().
  void initialize(scene::Scene& scene) const;
  /// Adds, to an initialized scene, those that a state of that time has; or all that ever came. Throws SetupError.
  void add_until(scene::Scene& scene, Duration state) const;
  void add_all(scene::Scene& scene) const { add_until(scene, Duration::max()); }
  /// Initializes, goes to the last whole state until `time`, or to the start, and schedules the later commands.
  /// Without `states` to the first one: the beginning of the run. Those who came later come again, so the recorded run outlives the scene's steps.
  void begin(scene::Scene& scene, Duration time, bool states = true) const;

 private:
  void check_repeatable(const scene::Scene& scene) const;
  void check_repeatable(const scene_file::RobotSpec& robot) const;
  void schedule(scene::Scene& scene, const RecordedAddition& addition) const;

  McapReader file_;
  std::vector<RecordedAddition> additions_;
  RunDescription description_;  // with channels and names of these
  UnpackedFiles files_;
  std::shared_ptr<const files::MovedFiles> moved_;  // into `files_`
  RecordedStates states_;
  std::shared_ptr<const ExternalInputLog> outside_;  // null: no external participants
  Duration end_{};
};

}  // namespace murosimf::recording
