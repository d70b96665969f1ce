/// series_arguments.h - the options of commands that run a scene many times: what all runs share, and how many run at a time.
#pragma once

#include <optional>
#include <string>

#include "apps/command.h"
#include "apps/scene_arguments.h"

namespace murosimf::app {

struct SeriesArguments {
  SeriesArguments();

  SceneArguments scene;            ///< `threads`: runs at a time, as many as the machine has processors
  std::optional<double> duration;  ///< [s]
  bool no_cameras = false;
  std::string json;  ///< file for the result
};

/// How all runs are changed, and how they are run.
void add_series(const Command& command, SeriesArguments& arguments);
/// Results as JSON, and what is loaded. Commands put these last.
void add_series_end(const Command& command, SeriesArguments& arguments);
/// Of all runs. Loads plug-ins; throws SetupError.
[[nodiscard]] scene::SceneOptions options_of(const SeriesArguments& arguments);

}  // namespace murosimf::app
