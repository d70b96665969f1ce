/// recording_capture.h - what a recording takes of a scene, and when: copied between two steps, in the simulation's thread.
///
/// Nothing of the scene changes. What has been taken is known here alone: which samples, pictures, events and commands are new.
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "murosimf/drawing/debug_draw_source.h"
#include "murosimf/recording/recorded_contacts.h"
#include "murosimf/recording/recorded_drawings.h"
#include "murosimf/recording/recorded_external_drawings.h"
#include "murosimf/recording/recorded_frame.h"
#include "murosimf/recording/recorded_paths.h"
#include "murosimf/recording/recorded_picture.h"
#include "murosimf/scene/scene.h"

namespace murosimf::recording {

/// From when to when, both included.
struct TimeSpan {
  Duration begin{}, end{};
};

struct CaptureOptions {
  double rate = 100;           ///< [Hz] of frames
  std::set<std::string> what;  ///< of recordable()
  Duration state_period{};     ///< from one whole state to the next
  std::optional<TimeSpan> ticks{};
  const drawing::DebugDrawSource* others = nullptr;
};

class RecordingCapture {
 public:
  /// `paths` say what files are called in texts. Scene and paths outlive it. Throws SetupError for an impossible rate.
  RecordingCapture(scene::Scene& scene, CaptureOptions options, const RecordedPaths& paths);

  /// Of a scene that is initialized: from now on.
  void start();

  /// Whether robots or bodies have come that it does not know yet.
  [[nodiscard]] bool has_newcomers() const { return scene_.simulation().world().entities().size() > known_; }
  /// Knows them from now on: they are the last of each list.
  void meet_newcomers();

  [[nodiscard]] const std::vector<RecordedEntity>& entities() const noexcept { return entities_; }
  [[nodiscard]] const std::vector<RecordedSensor>& sensors() const noexcept { return sensors_; }
  [[nodiscard]] const std::vector<RecordedCamera>& cameras() const noexcept { return cameras_; }
  [[nodiscard]] const std::set<std::string>& what() const noexcept { return options_.what; }
  [[nodiscard]] double rate() const noexcept { return options_.rate; }  ///< [Hz]

  /// Whether a frame with poses is due.
  [[nodiscard]] bool frame_is_due() const { return scene_.simulation().now() >= next_frame_; }
  /// Takes one, in the memory of `frame`. The last one of a run has all that was not due.
  void take_frame(RecordedFrame& frame, bool is_last = false);
  /// Between two of these: samples and states; none: there is nothing new.
  [[nodiscard]] std::optional<RecordedFrame> take_between();
  /// When to look again.
  [[nodiscard]] Duration next_look() const;
  /// Whether something has happened that the last frame does not have.
  [[nodiscard]] bool has_news() const;

 private:
  [[nodiscard]] bool in_every_tick() const;
  void take_state(RecordedFrame& frame, bool is_last = false);
  void take_samples(RecordedFrame& frame);
  void take_drawings(RecordedFrame& frame, bool is_last);
  void take_lines(RecordedFrame& frame);

  scene::Scene& scene_;
  CaptureOptions options_;
  const RecordedPaths& paths_;
  Duration period_;
  std::size_t known_ = 0;  // entities of the world
  std::vector<RecordedEntity> entities_;
  std::vector<RecordedSensor> sensors_;
  std::vector<RecordedCamera> cameras_;
  SketchWatch sketches_;
  OthersWatch others_watch_;
  ContactWatch touching_;
  ExternalInputLog* outside_;  // null: what comes from outside is not written down
  Duration next_frame_{}, next_hash_{}, next_state_{}, next_others_{};
  std::optional<Duration> last_frame_;
  std::size_t events_ = 0, warnings_ = 0, commands_ = 0;  // that were taken
};

}  // namespace murosimf::recording
