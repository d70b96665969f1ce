/// recording_retention.h - which frames get into a recording: all, or those around something that happens, as in a flight recorder.
///
/// Frames are handed to the writer in batches of a tenth of a second. With `record_on` batches are held in memory, each beginning with a whole
/// state so that a run can go on from there, and forgotten when they are old, until something happens.
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "murosimf/recording/recording_writer.h"
#include "murosimf/recording/run_watch.h"

namespace murosimf::recording {

struct RetentionOptions {
  std::set<std::string> record_on{};  ///< of watchable(); empty: all frames stay
  Duration keep{}, after{};           ///< before and after what happens
};

class RecordingRetention {
 public:
  using Batch = RecordingThread::Batch;

  /// Scene and writer outlive it.
  RecordingRetention(const scene::Scene& scene, const RetentionOptions& options, RecordingWriter& writer);

  /// [s] of simulated time in a batch.
  static constexpr Duration batch_span = std::chrono::milliseconds(100);

  /// Whether frames are held until something happens.
  [[nodiscard]] bool waits() const noexcept { return watch_.has_value(); }
  /// From now on all gets into the file, with what is held, or no longer.
  void ask(bool on);
  /// Of record_on, so far.
  [[nodiscard]] std::size_t happened() const noexcept { return happened_; }

  /// Memory for the next frame.
  [[nodiscard]] RecordedFrame spare_frame();
  /// Of poses: looks for what has happened, too.
  void add_frame(RecordedFrame&& frame);
  /// Of samples and states alone.
  void add_between(RecordedFrame&& frame);
  /// What there is of the present batch goes the way of the others.
  void flush();
  /// Has the file begin with what is held, if it has not begun. Whether nothing is wrong with it.
  bool begin_file();

 private:
  void watch(RecordedFrame& frame);
  void begin_batch();
  void forget_old();
  void keep_outside(RecordedFrame& dropped, Batch& rest);
  void keep_drawings(std::vector<Batch>::iterator first_kept);

  const scene::Scene& scene_;
  RecordingWriter& writer_;
  Duration keep_, after_;
  std::optional<RunWatch> watch_;
  Batch batch_;              // the present one
  std::vector<Batch> held_;  // not in the file yet, the oldest first
  Batch spare_;              // frames that were written
  // of frames that are forgotten, so that the run can be repeated: what comes with the next thing that happens
  std::vector<std::pair<Duration, std::string>> commands_between_;
  std::vector<std::pair<std::string, ExternalInput>> outside_between_;
  Duration write_until_{-1};
  bool asked_ = false, newly_asked_ = false;
  std::size_t happened_ = 0;
};

}  // namespace murosimf::recording
