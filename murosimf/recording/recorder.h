/// recorder.h - records a scene while it runs, as an MCAP file for Foxglove, Lichtblick, PlotJuggler and Rerun.
///
///     const files::FilesRead read;
///     scene::Scene scene("three_on_three");
///     recording::Recorder recorder(scene, {.file = "game.mcap", .files = &read});
///     scene.simulation().run(30s);
///     recorder.finish(make_report(scene));
///
/// What is recorded is copied between two steps and written by a thread (recording_thread.h). Recording changes no result.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "murosimf/drawing/debug_draw_source.h"
#include "murosimf/files/files_read.h"
#include "murosimf/recording/attached_files.h"
#include "murosimf/recording/frame_writer.h"
#include "murosimf/recording/mcap/mcap_reader.h"
#include "murosimf/recording/mcap/mcap_writer.h"
#include "murosimf/recording/recorded_contacts.h"
#include "murosimf/recording/recorded_drawings.h"
#include "murosimf/recording/recorded_external_drawings.h"
#include "murosimf/recording/recorded_picture.h"
#include "murosimf/recording/recording_thread.h"
#include "murosimf/recording/run_description.h"
#include "murosimf/recording/run_watch.h"
#include "murosimf/scene/run_report.h"
#include "murosimf/scene/scene.h"

namespace murosimf::recording {

/// From when to when, both included.
struct TimeSpan {
  Duration begin{}, end{};
};

struct RecorderOptions {
  std::filesystem::path file;
  double rate = 100;                                ///< [Hz] of poses, joints and contacts; sensors have their own
  std::set<std::string> what = usually_recorded();  ///< of recordable()
  std::string program{};                            ///< "murosimf 0.1.0 (136ba27)"
  std::string command_line{};
  Duration state_period = std::chrono::seconds(30);  ///< from one whole state to the next, if "states" are recorded
  std::optional<TimeSpan> ticks{};  ///< with hash and state of every step; of other times as `what` and rates say
  std::set<std::string>
      record_on{};  ///< of watchable(): only what is around such an event gets into the file; empty: all
  Duration keep = std::chrono::seconds(30);  ///< before it,
  Duration after = std::chrono::seconds(2);  ///< and after it
  std::optional<RunDescription>
      run{};  ///< how it was begun (`names` as `files` says): with the files it can be repeated
  /// Which files the scene was read from, until the first step; hashes of all and contents of small ones are recorded. Null: none.
  const files::FilesRead* files = nullptr;
  /// Instead, the recording that it repeats, whose `run` has the names, too.
  const McapReader* files_of = nullptr;
  bool in_the_middle =
      false;  ///< the scene is initialized already: the file begins with its next step, as one that went on from a state
  /// What other programs draw, a part of "drawings"; must outlive the run. Null: nobody else draws.
  const drawing::DebugDrawSource* others = nullptr;
};

/// It must live as long as the run lasts, and the scene longer.
class Recorder {
 public:
  /// Before the first step, with which the file begins: until then none changes, but it is taken (mcap/growing_file.h). Throws SetupError
  /// for a file that cannot be written, or that another run writes, and for an impossible rate.
  Recorder(scene::Scene& scene, const RecorderOptions& options);
  /// Without finish() the file is one that was cut off.
  ~Recorder();
  Recorder(const Recorder&) = delete;  // the simulation calls back
  Recorder& operator=(const Recorder&) = delete;

  /// The last frame, the report and the summary. Steps that follow are not recorded.
  void finish(const scene::RunReport& report);
  /// With record_on: from now on all is recorded, with what was kept before, or no longer, as often as one likes. Between two steps.
  void ask(bool on);
  /// A text that belongs to the run, before finish().
  void attach(const std::string& name, const std::string& text) { texts_.emplace_back(name, text); }
  /// Why nothing is recorded any more, in one line; empty: all is well.
  [[nodiscard]] std::string trouble() const;
  /// Of record_on, so far.
  [[nodiscard]] std::size_t happened() const { return happened_; }
  /// Where what is recorded is, and what was found there.
  [[nodiscard]] const GrowingFile& file() const { return file_.file(); }

 private:
  void describe();
  template <class Call>
  bool on_file(const Call& call);
  void attach_text(const std::string& name, const std::string& text);
  void start();
  void look();
  void take_frame(bool is_last = false);
  [[nodiscard]] RecordedFrame new_frame();
  void take_state(RecordedFrame& frame, bool is_last = false);
  [[nodiscard]] bool in_every_tick() const;
  [[nodiscard]] Duration next_look() const;
  void take_samples(RecordedFrame& frame);
  void take_drawings(RecordedFrame& frame, bool is_last);
  void take_lines(RecordedFrame& frame);
  void add(RecordedFrame&& frame);
  void hand_over();
  void begin_batch();
  void watch(RecordedFrame& frame);
  void begin_file();
  void forget_old();
  void keep_outside(RecordedFrame& dropped, RecordingThread::Batch& rest);
  void keep_drawings(std::vector<RecordingThread::Batch>::iterator first_kept);
  void write(const RecordingThread::Batch& batch);

  scene::Scene& scene_;
  double rate_;  // [Hz]
  Duration period_;
  std::set<std::string> what_;
  std::string program_, command_line_;
  const files::FilesRead* files_read_;
  const McapReader* files_of_;
  RecordedPaths paths_;
  AttachedFiles files_now_;
  Duration state_period_;
  std::optional<TimeSpan> ticks_;
  std::optional<RunDescription> run_;
  McapWriter file_;
  std::vector<RecordedEntity> entities_;
  std::vector<RecordedSensor> sensors_;
  std::vector<RecordedCamera> cameras_;
  SketchWatch sketches_;
  const drawing::DebugDrawSource* others_;
  OthersWatch others_watch_;
  ContactWatch touching_;
  std::unique_ptr<SceneLooks> looks_;
  std::unique_ptr<FrameWriter> frames_;
  std::unique_ptr<PictureWriter> pictures_;
  std::unique_ptr<DrawingWriter> drawings_;
  std::vector<std::pair<std::string, std::string>> texts_;
  Duration next_frame_{}, next_hash_{}, next_state_{}, next_others_{};
  std::optional<Duration> last_frame_;
  std::size_t events_ = 0, warnings_ = 0, commands_ = 0;  // that are recorded
  RecordingThread::Batch batch_;
  RecordingThread::Batch spare_;  // frames that were written
  Duration keep_, after_;
  std::optional<RunWatch> watch_;
  std::vector<RecordingThread::Batch> held_;                        // not in the file yet
  std::vector<std::pair<Duration, std::string>> commands_between_;  // of what will never be in it
  ExternalInputLog* outside_;                                       // null: it is not written down
  std::vector<std::pair<std::string, ExternalInput>> outside_between_;
  Duration write_until_{-1};
  bool began_ = false, asked_ = false, newly_asked_ = false, finished_ = false;
  std::size_t happened_ = 0;
  std::chrono::steady_clock::time_point synced_{};  // of the thread
  std::string file_trouble_;                        // besides that of the thread
  std::unique_ptr<RecordingThread> thread_;
};

/// The layout for Foxglove and Lichtblick (JSON) that shows these files: bodies, forces, joints and messages.
[[nodiscard]] std::string foxglove_layout(const std::vector<std::string>& robots);

}  // namespace murosimf::recording
