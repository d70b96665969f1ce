/// html_recording.h - a run as one self-contained HTML file that plays in any browser: page, appearance, poses and drawings.
///
///     scene::Scene scene("three_on_three");
///     web::HtmlRecording recording(scene, {.file = "game.html"});
///     scene.simulation().run(60s);
///     recording.finish();
///
/// Poses are rounded as in pose_message.h, drawings to 1 mm, and stored as docs/web.md says. An entity that comes to the run is shown from the next frame on; looks are
/// those of the first frame, or of the one in which the last one came. Recording changes no result.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "murosimf/drawing/debug_draw_source.h"
#include "murosimf/runtime/pose_frame.h"
#include "murosimf/scene/scene.h"
#include "murosimf/web/drawing_tracks.h"
#include "murosimf/web/scene_document.h"

namespace murosimf::web {

struct HtmlOptions {
  std::filesystem::path file;
  double rate = 25;      ///< [Hz] of frames; the page interpolates between them
  bool by_hand = false;  ///< only take_frame() adds frames: for a scene without steps
  const drawing::DebugDrawSource* others =
      nullptr;  ///< drawings of other programs; must outlive the recording; null: none
};

/// It must outlive the run, and the scene must outlive it.
class HtmlRecording {
 public:
  /// Before the first step. Throws SetupError: this program has no page, the file is not writable, an invalid rate.
  HtmlRecording(scene::Scene& scene, HtmlOptions options);
  HtmlRecording(const HtmlRecording&) = delete;  // the simulation calls back
  HtmlRecording& operator=(const HtmlRecording&) = delete;

  /// Adds a frame of the present instant, a period after the previous one.
  void take_frame();
  /// Adds a line to those that the page lists, with which people jump to an instant; with any, they stand in the place of events and
  /// warnings of the run.
  void note(Duration time, const std::string& text);
  [[nodiscard]] Duration period() const { return period_; }
  /// Writes the file, which is complete or absent. Throws SetupError.
  void finish();

 private:
  void start();
  void look();
  void lengthen_frames(std::size_t rows);
  void take_drawings();
  [[nodiscard]] nlohmann::json lines() const;
  [[nodiscard]] std::string packed() const;

  scene::Scene& scene_;
  HtmlOptions options_;
  SceneDocument document_;
  Duration period_;
  std::vector<Duration> times_;
  std::vector<std::string> frames_;  // pose messages, all of the same size
  std::vector<std::pair<Duration, std::string>> notes_;
  PoseFrame poses_;
  DrawingTracks drawings_;
  std::optional<std::pair<std::uint64_t, std::uint64_t>> drawn_;  // processed changes, of robots and of others
};

/// Transposes frames of equal size into columns of differences, which compress well: word by word (16 bits) the differences from frame to frame, low
/// bytes of all frames, then high bytes.
[[nodiscard]] std::string as_planes(const std::vector<std::string>& frames);

}  // namespace murosimf::web
