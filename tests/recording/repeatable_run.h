/// repeatable_run.h - records a run so that it can be repeated, as the program does.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "murosimf/recording/recorder.h"
#include "murosimf/scene/scene_report.h"
#include "tests/temp_folder.h"

namespace murosimf::fixtures {

struct RepeatableRun {
  std::string scene;
  Duration time{};
  recording::RecorderOptions options{};
  scene::SceneOptions how{.cameras = false};
  std::function<void(scene::Scene&)> when_built{}, when_initialized{};
};

/// Its file.
inline std::filesystem::path record(const std::string& name, const RepeatableRun& run) {
  files::FilesRead read;
  recording::RecorderOptions options = run.options;
  scene::Scene scene(run.scene, run.how);
  if (run.when_built) run.when_built(scene);
  options.file = temp_folder() / name;
  options.files = &read;
  options.run = recording::RunDescription{.scene = run.scene,
                                          .seed = scene.spec().seed,
                                          .overrides = run.how.overrides,
                                          .events = run.how.events,
                                          .pushes = run.how.pushes,
                                          .plugins = {},
                                          .cameras = run.how.cameras,
                                          .pushable = run.how.pushable,
                                          .outside = {},
                                          .names = {}};
  recording::Recorder recorder(scene, options);
  scene.simulation().initialize();
  if (run.when_initialized) run.when_initialized(scene);
  scene.simulation().run(run.time);
  recorder.finish(make_report(scene));
  EXPECT_EQ(recorder.trouble(), "");
  return options.file;
}

}  // namespace murosimf::fixtures
