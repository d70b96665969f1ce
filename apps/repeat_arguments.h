/// repeat_arguments.h - the options of commands that build a recorded run again.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "apps/command.h"
#include "apps/scene_arguments.h"
#include "murosimf/recording/recorded_run.h"

namespace murosimf::app {

struct RepeatArguments {
  int threads = 1;
  std::vector<std::string> plugins;
  bool libraries = false;
};

void add_repeat(const Command& command, RepeatArguments& arguments);
/// A signal stops it (interruption.h).
[[nodiscard]] recording::RepeatOptions options_of(const RepeatArguments& arguments);

/// Of a command that takes a recording in the place of a scene.
[[nodiscard]] RepeatArguments repeat_arguments(const SceneArguments& arguments);
/// Throws SetupError for options that would make another run of it.
void refuse_changes(const SceneArguments& arguments);

/// One that is looked at, with the plug-ins that were named loaded. Throws SetupError.
[[nodiscard]] std::shared_ptr<const recording::RecordedRun> recorded_run_of(const std::string& file,
                                                                            const RepeatArguments& arguments);

/// Recordings never load code by themselves: says which plug-ins a run had that were not named now. Throws SetupError.
void check_plugins(const recording::RecordedRun& run, const RepeatArguments& arguments);

}  // namespace murosimf::app
