/// record_options.h - the options of `murosimf run` that record it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "apps/command.h"
#include "apps/scene_arguments.h"
#include "murosimf/drawing/debug_draw_source.h"
#include "murosimf/files/files_read.h"
#include "murosimf/recording/recorded_run.h"
#include "murosimf/recording/recorder.h"

namespace murosimf::app {

struct RecordOptions {
  std::string file;               ///< MCAP; empty: nothing is recorded
  double rate = 100;              ///< [Hz]
  std::vector<std::string> what;  ///< of recording::recordable(); none: what usually is
  double states = 30;             ///< [s] from one whole state to the next
  std::string ticks;              ///< BEGIN..END [s]: every step
  std::vector<std::string> on;    ///< of recording::watchable(); none: all of the run
  double keep = 30;               ///< [s] before that
};

void add_record(const Command& command, RecordOptions& options);

/// How the run is begun, so that it can be repeated.
[[nodiscard]] recording::RunDescription description_of(const SceneArguments& arguments, const scene::Scene& scene,
                                                       const scene::SceneOptions& options);

/// "murosimf 0.1.0 (136ba27)"
[[nodiscard]] std::string this_program();
/// The command line as it could be typed again; empty where the system has no record of it.
[[nodiscard]] std::string command_line();

/// Whether recording is switched on and off during the run.
[[nodiscard]] bool is_asked_for(const RecordOptions& options);

/// `somebody_asks`: whether others can. Throws SetupError as files::claim_output.
void check(const RecordOptions& options, bool somebody_asks);

/// Null if nothing is recorded. `files`: notes what the scene is read from, until the first step, with `run` so that it can be repeated;
/// `others`: what other programs draw, null: they do not. Before that. Throws SetupError.
[[nodiscard]] std::unique_ptr<recording::Recorder> make_recorder(scene::Scene& scene, const RecordOptions& options,
                                                                 const files::FilesRead& files,
                                                                 const recording::RunDescription& run,
                                                                 const drawing::DebugDrawSource* others);
/// The same for a scene that repeats a recorded run.
[[nodiscard]] std::unique_ptr<recording::Recorder> make_recorder(scene::Scene& scene, const RecordOptions& options,
                                                                 const recording::RecordedRun& run);

/// Prints why nothing is recorded any more, if that is so; to be called before finish() unless it was printed during the run.
void say_trouble(const recording::Recorder& recorder);

/// Writes what is left, and a layout for Foxglove beside the recording. Prints an error once; returns whether there was none.
[[nodiscard]] bool finish(recording::Recorder& recorder, const scene::RunReport& report, const RecordOptions& options);

}  // namespace murosimf::app
