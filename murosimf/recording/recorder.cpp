#include "murosimf/recording/recorder.h"

#include <algorithm>
#include <utility>

#include "murosimf/model/error.h"

namespace murosimf::recording {
namespace {

/// What is held until something happens begins with a state, so there are some at least every quarter of `keep`.
CaptureOptions capture_options(const RecorderOptions& options) {
  CaptureOptions capture{.rate = options.rate,
                         .what = options.what,
                         .state_period = options.state_period,
                         .ticks = options.ticks,
                         .others = options.others};
  if (options.record_on.empty()) return capture;
  capture.what.insert("states");
  capture.state_period = std::min(capture.state_period, std::max(options.keep / 4, RecordingRetention::batch_span));
  return capture;
}

RetentionOptions retention_options(const RecorderOptions& options) {
  if (!options.record_on.empty() && options.what.contains("pictures")) {
    throw SetupError("pictures of cameras are not kept until something happens");
  }
  return {.record_on = options.record_on, .keep = options.keep, .after = options.after};
}

}  // namespace

Recorder::Recorder(scene::Scene& scene, const RecorderOptions& options)
    : scene_(scene),
      header_(scene, {.rate = options.rate,
                      .program = options.program,
                      .command_line = options.command_line,
                      .run = options.run,
                      .files = options.files,
                      .files_of = options.files_of}),
      capture_(scene, capture_options(options), header_.paths()),
      writer_(options.file, options.program, header_),
      retention_(scene, retention_options(options), writer_) {
  if (options.what.contains("pictures")) want_pictures(scene.simulation().world());
  // later than the simulation's schedule is made: a state that is loaded knows nothing of the recorder
  const auto begin = [this] { scene_.simulation().at(Duration{}, [this] { start(); }); };
  scene.simulation().after_start(begin);
  if (options.in_the_middle) begin();
}

/// The files of meshes are known only when the scene is initialized.
void Recorder::start() {
  if (finished_) return;
  if (writer_.has_channels()) throw SetupError("a recording is of one run: this one began anew");
  capture_.start();
  header_.take_files();
  if (!retention_.waits() && !retention_.begin_file()) return;
  writer_.open_channels(scene_, capture_);
  look();
}

/// Between two steps: what is due is taken.
void Recorder::look() {
  if (finished_) return;
  meet_newcomers();
  if (capture_.frame_is_due()) {
    take_frame();
  } else if (auto frame = capture_.take_between()) {
    retention_.add_between(*std::move(frame));
  }
  scene_.simulation().at(capture_.next_look(), [this] { look(); });
}

void Recorder::meet_newcomers() {
  if (!capture_.has_newcomers()) return;
  writer_.meet_newcomers(scene_, capture_, [this] {
    capture_.meet_newcomers();
    header_.take_additions();
  });
}

void Recorder::take_frame(bool is_last) {
  RecordedFrame frame = retention_.spare_frame();
  capture_.take_frame(frame, is_last);
  retention_.add_frame(std::move(frame));
}

void Recorder::finish(const scene::RunReport& report) {
  if (!writer_.has_channels() && trouble().empty()) start();  // of a run without steps
  finished_ = true;
  if (!writer_.has_channels()) return;
  meet_newcomers();
  if (capture_.has_news()) take_frame(true);  // of after the last step
  retention_.flush();
  (void)retention_.begin_file();
  writer_.finish(report);
}

}  // namespace murosimf::recording
