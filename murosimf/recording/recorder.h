/// recorder.h - records a scene while it runs, as an MCAP file for Foxglove, Lichtblick, PlotJuggler and Rerun.
///
///     const files::FilesRead read;
///     scene::Scene scene("three_on_three");
///     recording::Recorder recorder(scene, {.file = "game.mcap", .files = &read});
///     scene.simulation().run(30s);
///     recorder.finish(make_report(scene));
///
/// What is recorded is copied between two steps (recording_capture.h); what of it stays is decided (recording_retention.h), and a thread
/// writes that (recording_writer.h). Recording changes no result.
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>

#include "murosimf/drawing/debug_draw_source.h"
#include "murosimf/files/files_read.h"
#include "murosimf/recording/frame_writer.h"
#include "murosimf/recording/mcap/mcap_reader.h"
#include "murosimf/recording/recording_capture.h"
#include "murosimf/recording/recording_header.h"
#include "murosimf/recording/recording_retention.h"
#include "murosimf/recording/recording_writer.h"
#include "murosimf/recording/run_description.h"
#include "murosimf/scene/run_report.h"
#include "murosimf/scene/scene.h"

namespace murosimf::recording {

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
  /// What other programs draw, a part of "drawings"; must outlive the run. Null: there are no other programs.
  const drawing::DebugDrawSource* others = nullptr;
};

/// It must live as long as the run lasts, and the scene longer.
class Recorder {
 public:
  /// Before the first step, with which the file begins: until then none changes, but it is taken (mcap/growing_file.h). Throws SetupError
  /// for a file that cannot be written, or that another run writes, and for an impossible rate.
  Recorder(scene::Scene& scene, const RecorderOptions& options);
  /// Without finish() the file is one that was cut off.
  ~Recorder() = default;
  Recorder(const Recorder&) = delete;  // the simulation calls back
  Recorder& operator=(const Recorder&) = delete;

  /// The last frame, the report and the summary. Steps that follow are not recorded.
  void finish(const scene::RunReport& report);
  /// With record_on: from now on all is recorded, with what was kept before, or no longer, as often as one likes. Between two steps.
  void ask(bool on) { retention_.ask(on); }
  /// A text that belongs to the run, before finish().
  void attach(const std::string& name, const std::string& text) { header_.add_text(name, text); }
  /// Why nothing is recorded any more, in one line; empty: all is well.
  [[nodiscard]] std::string trouble() const { return writer_.trouble(); }
  /// Of record_on, so far.
  [[nodiscard]] std::size_t happened() const noexcept { return retention_.happened(); }
  /// Where what is recorded is, and what was found there.
  [[nodiscard]] const GrowingFile& file() const noexcept { return writer_.file(); }

 private:
  void start();
  void look();
  void meet_newcomers();
  void take_frame(bool is_last = false);

  scene::Scene& scene_;
  RecordingHeader header_;
  RecordingCapture capture_;  // the writer's channels are of what it takes
  RecordingWriter writer_;
  RecordingRetention retention_;
  bool finished_ = false;
};

}  // namespace murosimf::recording
