/// recorded_source.h - plays a recording in a session: viewers and servers show the recorded data of each instant; nothing is
/// computed.
///
///     const auto run = std::make_shared<const recording::RecordedRun>("game.mcap");
///     session::Session session(std::make_unique<recording::RecordedSource>(run), {.speed = 1.0});
///     session.run(run->end());
///
/// Shown are poses, joints, contacts, drawings, events, warnings and levels of detail. Changes are refused; robots and
/// bodies that came to the run are shown from then on.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/drawing/debug_draw_source.h"
#include "murosimf/recording/frame_reader.h"
#include "murosimf/recording/recorded_drawings.h"
#include "murosimf/recording/recorded_external_drawings.h"
#include "murosimf/recording/recorded_run.h"
#include "murosimf/session/playback_source.h"

namespace murosimf::recording {

class RecordedSource final : public session::PlaybackSource {
 public:
  /// `others`: receives the recorded drawings of other programs; null: not shown. Throws SetupError: the file has no poses, or its scene
  /// cannot be built.
  explicit RecordedSource(std::shared_ptr<const recording::RecordedRun> run,
                          const recording::RepeatOptions& options = {},
                          std::shared_ptr<drawing::DebugDrawBuffer> others = nullptr);
  ~RecordedSource() override;

  [[nodiscard]] scene::Scene& scene() override { return *scene_; }
  void begin() override;
  void step() override;
  [[nodiscard]] bool at_end() const override;
  void reset(std::optional<std::uint64_t> seed) override;
  void seek(Duration time, std::optional<int> branch, const std::function<bool()>& given_up) override;
  void load(const std::function<void(scene::Scene&)>& load) override;
  void change(const std::vector<std::string>& changes) override;

  [[nodiscard]] int branch() const override { return 0; }
  [[nodiscard]] Duration first() const override { return frames_->begin(); }
  [[nodiscard]] Duration last() const override { return frames_->end(); }
  [[nodiscard]] std::vector<session::BranchView> branches() const override;
  [[nodiscard]] bool has_grown() override;
  [[nodiscard]] const std::vector<std::string>& known_properties() const override { return known_; }

 private:
  struct LevelChange {
    Duration time{};
    std::size_t entity = 0;
    std::string level;
  };
  void make_room_for_drawings();
  void show(Duration time);
  void read_lines();
  void find_levels();
  void show_entity(std::size_t index, const recording::RecordedFrame& frame, std::size_t link, std::size_t joint);
  void show_drawings(Duration time);
  void show_levels(Duration time);

  std::shared_ptr<const recording::RecordedRun> run_;
  std::unique_ptr<scene::Scene> scene_;
  std::vector<recording::RecordedEntity> entities_;
  std::unique_ptr<recording::FrameReader> frames_;
  recording::DrawingReader drawings_;
  std::shared_ptr<drawing::DebugDrawBuffer> others_;
  std::optional<recording::RecordedExternalDrawings> others_then_;
  std::vector<Event> events_;                               // of the whole run, by time
  std::vector<std::pair<Duration, std::string>> warnings_;  // likewise
  std::vector<std::string> warnings_so_far_;
  std::vector<LevelChange> levels_;  // those of the start, then by time
  std::vector<ContactMark> contacts_;
  std::vector<std::string> known_;
  bool told_ = false;
};

}  // namespace murosimf::recording
