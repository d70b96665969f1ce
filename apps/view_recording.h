/// view_recording.h - records what is shown in a window, all of it or while the user wants it.
#pragma once

#include <chrono>
#include <memory>
#include <string>

#include "apps/record_options.h"
#include "apps/scene_arguments.h"
#include "murosimf/drawing/debug_draw_source.h"
#include "murosimf/session/playback_source.h"

namespace murosimf::app {

class ViewRecording {
 public:
  /// All must outlive it. `others`: what other programs draw; null: they do not. Throws SetupError if the file could not be written now.
  ViewRecording(const SceneArguments& scene, const RecordOptions& options, const drawing::DebugDrawSource* others);

  /// The scene with its recorder; once. Throws SetupError.
  [[nodiscard]] std::unique_ptr<session::PlaybackSource> make_source(const scene::SceneOptions& options);
  /// From now on, or no longer; in the thread that runs the scene.
  void record(bool on) { recorder_->ask(on); }
  /// Why the window cannot go back in time.
  [[nodiscard]] static std::string no_way_back() { return "the run is recorded"; }
  /// When nothing runs any more: writes what is left; whether the recording has all of it.
  [[nodiscard]] bool finish();

 private:
  const SceneArguments& arguments_;
  const RecordOptions& options_;
  const drawing::DebugDrawSource* others_;
  std::shared_ptr<files::FilesRead> files_ = std::make_shared<files::FilesRead>();  // that the scene is made of
  scene::Scene* scene_ = nullptr;
  std::unique_ptr<recording::Recorder> recorder_;
  std::chrono::steady_clock::time_point begin_;
};

}  // namespace murosimf::app
