/// run_outputs.h - outputs of a run: logs, recordings, states, pictures, reports.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "apps/picture_sequence.h"
#include "apps/run_options.h"
#include "apps/state_saver.h"
#include "murosimf/drawing/debug_draw_source.h"
#include "murosimf/files/file_access.h"
#include "murosimf/logging/run_log.h"
#include "murosimf/recording/recorder.h"
#include "murosimf/scene/run_report.h"
#include "murosimf/web/html_recording.h"

namespace murosimf::app {

class RunOutputs {
 public:
  /// Where results go is checked before anything is computed, so that none is lost. Throws SetupError.
  explicit RunOutputs(const RunOptions& options);

  /// Before the first step. `game`: null, if there is none; `others`: what other programs draw until write(), null: they do not.
  void attach(scene::Scene& scene, const scene::SceneOptions& scene_options, const league::League* game,
              const drawing::DebugDrawSource* others);
  /// When the scene is initialized: what is read from now on is none of its files.
  void scene_is_read() { noting_.end(); }
  /// Those that were.
  [[nodiscard]] const std::vector<std::filesystem::path>& files_read() const { return files_->list(); }
  /// When a state is loaded, if one is.
  void begin();

  /// Null if none are taken.
  [[nodiscard]] PictureSequence* pictures() { return pictures_ ? &*pictures_ : nullptr; }
  /// Why nothing is recorded any more; empty: it is, or nothing was to be recorded.
  [[nodiscard]] std::string trouble() const { return recorder_ ? recorder_->trouble() : ""; }

  /// The state of now, as the file of --save-state has it. Throws SetupError.
  [[nodiscard]] std::string state_of(scene::Scene& scene) const { return saver_.state_of(scene); }
  /// Has it recorded, or no longer; null: recording is not switched during the run.
  [[nodiscard]] std::function<void(bool)> record_switch() const;

  struct Written {
    bool recording = true;  ///< all of it
    bool states = true;     ///< also those of times that the run should have come to
    bool files = true;      ///< all others
  };
  /// Writes all of it. Errors are printed; the rest is written all the same.
  [[nodiscard]] Written write(const scene::RunReport& report);

 private:
  const RunOptions& options_;
  StateSaver saver_;
  std::optional<PictureSequence> pictures_;
  std::shared_ptr<files::FilesRead> files_ = std::make_shared<files::FilesRead>();  // what is read from here on
  files::FileScope noting_{{.noted = files_}};
  recording::RunDescription description_;
  scene::Scene* scene_ = nullptr;
  const league::League* game_ = nullptr;
  std::optional<logging::RunLog> log_;
  std::unique_ptr<recording::Recorder> recorder_;
  std::unique_ptr<web::HtmlRecording> html_;
};

}  // namespace murosimf::app
