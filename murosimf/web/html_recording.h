/// html_recording.h - a run as one HTML file that plays by itself in any browser: page, looks, poses and drawings in it.
///
///     scene::Scene scene("three_on_three");
///     web::HtmlRecording recording(scene, {.file = "game.html"});
///     scene.simulation().run(60s);
///     recording.finish();
///
/// Poses are rounded as in pose_message.h, drawings to 1 mm, and stored as docs/web.md says. Recording changes no result.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "murosimf/drawing/debug_draw_source.h"
#include "murosimf/runtime/pose_frame.h"
#include "murosimf/scene/scene.h"
#include "murosimf/web/drawing_tracks.h"
#include "murosimf/web/scene_document.h"

namespace murosimf::web {

struct HtmlOptions {
  std::filesystem::path file;
  double rate = 25;      ///< [Hz] of frames; the page shows what is between them
  bool by_hand = false;  ///< frames are those of take_frame() alone: of a scene that makes no steps
  const drawing::DebugDrawSource* others =
      nullptr;  ///< what other programs draw; must outlive the recording; null: they do not
};

/// It must live as long as the run lasts, and the scene longer.
class HtmlRecording {
 public:
  /// Before the first step. Throws SetupError: this program has no page, the file could not be written, an impossible rate.
  HtmlRecording(scene::Scene& scene, HtmlOptions options);
  HtmlRecording(const HtmlRecording&) = delete;  // the simulation calls back
  HtmlRecording& operator=(const HtmlRecording&) = delete;

  /// One more, as it is now, a period after the one before.
  void take_frame();
  [[nodiscard]] Duration period() const { return period_; }
  /// Writes the file, which is whole or not there at all. Throws SetupError.
  void finish();

 private:
  void start();
  void look();
  void take_drawings();
  [[nodiscard]] std::string packed() const;

  scene::Scene& scene_;
  HtmlOptions options_;
  SceneDocument document_;
  Duration period_;
  std::vector<Duration> times_;
  std::vector<std::string> frames_;  // pose messages, all of the same size
  PoseFrame poses_;
  DrawingTracks drawings_;
  std::optional<std::pair<std::uint64_t, std::uint64_t>> drawn_;  // changes that were taken, of robots and of others
};

/// Frames of equal size as columns of differences, which compress well: word by word (16 bits) the differences from frame to frame, low
/// bytes of all frames, then high bytes.
[[nodiscard]] std::string as_planes(const std::vector<std::string>& frames);

}  // namespace murosimf::web
