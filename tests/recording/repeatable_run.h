/// repeatable_run.h - records a run so that it can be repeated, as the program does.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "murosimf/recording/recorder.h"
#include "murosimf/recording/rerun.h"
#include "murosimf/scene/scene_report.h"
#include "tests/temp_folder.h"

namespace murosimf::fixtures {

struct RepeatableRun {
  std::string scene;
  Duration time{};
  recording::RecorderOptions options{};
  scene::SceneOptions how{.cameras = false};
  std::function<void(scene::Scene&)> when_built{}, when_initialized{};
  std::function<void(scene::Scene&, recording::Recorder&)> play{};  ///< in the place of a run of that time
};

/// Its file.
inline std::filesystem::path record(const std::string& name, const RepeatableRun& run) {
  const auto read = std::make_shared<files::FilesRead>();
  const files::FileScope noting({.noted = read});
  recording::RecorderOptions options = run.options;
  scene::Scene scene(run.scene, run.how);
  if (run.when_built) run.when_built(scene);
  options.file = temp_folder() / name;
  options.files = read.get();
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
  if (run.play) {
    run.play(scene, recorder);
  } else {
    scene.simulation().run(run.time);
  }
  recorder.finish(make_report(scene));
  EXPECT_EQ(recorder.trouble(), "");
  return options.file;
}

/// What is recorded can be repeated from the file alone, with any number of threads, and goes on from any of its states as it did.
inline void expect_repeatable(const std::filesystem::path& file) {
  const recording::RecordedRun recorded(file);
  for (const int threads : {1, 2}) {
    const recording::RerunResult result = recording::rerun(recorded, {.repeat = {.threads = threads}});
    EXPECT_FALSE(result.difference) << threads << " threads: " << to_text(result);
    EXPECT_GE(result.compared, 2U);
  }
  const recording::RecordedState& last = recorded.states().all().back();
  for (const recording::RecordedState& state : recorded.states().all()) {
    if (!state.chunk || state.time == last.time) continue;
    const auto scene = recorded.build({});
    recorded.begin(*scene, state.time);
    EXPECT_EQ(scene->simulation().now(), state.time);
    scene->simulation().run(last.time - state.time);
    EXPECT_EQ(scene->simulation().state_hash(), last.hash) << "from " << seconds(state.time) << " s";
  }
}

}  // namespace murosimf::fixtures
