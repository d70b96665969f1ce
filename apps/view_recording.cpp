#include "apps/view_recording.h"

#include <utility>

#include "murosimf/files/file_access.h"
#include "murosimf/model/error.h"
#include "murosimf/scene/scene_report.h"
#include "murosimf/session/live_source.h"

namespace murosimf::app {

ViewRecording::ViewRecording(const SceneArguments& scene, const RecordOptions& options,
                             const drawing::DebugDrawSource* others)
    : arguments_(scene), options_(options), others_(others) {
  check(options, true);
}

std::unique_ptr<session::PlaybackSource> ViewRecording::make_source(const scene::SceneOptions& options) {
  if (scene_) throw SetupError("no other scene: " + no_way_back());
  const files::FileScope noting({.noted = files_});
  auto scene = std::make_unique<scene::Scene>(arguments_.file, options);
  recorder_ = make_recorder(*scene, options_, *files_, description_of(arguments_, *scene, options), others_);
  scene->simulation().initialize();
  scene_ = scene.get();
  begin_ = std::chrono::steady_clock::now();
  return std::make_unique<session::LiveSource>(std::move(scene), session::LiveOptions{.no_way_back = no_way_back()});
}

bool ViewRecording::finish() {
  const auto wall = std::chrono::duration_cast<Duration>(std::chrono::steady_clock::now() - begin_);
  say_trouble(*recorder_);
  return app::finish(*recorder_, scene::make_report(*scene_, wall), options_);
}

}  // namespace murosimf::app
