#include "murosimf/recording/recording_writer.h"

#include <utility>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/scene/scene_labels.h"

namespace murosimf::recording {
namespace {

// With a batch on its way, and those that wait, less than a second of simulated time is not in the file.
constexpr Duration chunk_span = std::chrono::milliseconds(400);

}  // namespace

RecordingWriter::RecordingWriter(const std::filesystem::path& file, const std::string& library, RecordingHeader& header)
    : file_(file, {.library = library, .chunk_span = chunk_span}),
      header_(header),
      thread_(std::make_unique<RecordingThread>([this](const Batch& batch) { write(batch); })) {}

void RecordingWriter::open_channels(const scene::Scene& scene, const RecordingCapture& capture) {
  MUROSIMF_ASSERT(!frames_);
  if (capture.what().contains("scene")) looks_ = std::make_unique<SceneLooks>(scene, capture.entities());
  frames_ = std::make_unique<FrameWriter>(file_, capture.entities(), capture.sensors(), looks_.get(), capture.what());
  pictures_ = std::make_unique<PictureWriter>(file_, *frames_, capture.cameras(), scene::label_table_json(scene));
  drawings_ = std::make_unique<DrawingWriter>(file_, *frames_);
}

/// Batches that are on their way have the first ones of longer lists.
void RecordingWriter::meet_newcomers(const scene::Scene& scene, const RecordingCapture& capture,
                                     const std::function<void()>& meet) {
  MUROSIMF_ASSERT(frames_);
  const std::lock_guard lock(writing_);
  (void)on_file([&] {
    meet();
    auto looks = looks_ ? std::make_unique<SceneLooks>(scene, capture.entities()) : nullptr;
    frames_->meet_newcomers(looks.get());
    looks_ = std::move(looks);
    pictures_->meet_newcomers(scene::label_table_json(scene));
    if (began_) header_.write_additions(file_);
  });
}

/// Whether nothing is wrong with the file.
template <class Call>
bool RecordingWriter::on_file(const Call& call) {
  if (!trouble().empty()) return false;
  try {
    call();
  } catch (const SetupError& error) {
    file_trouble_ = error.what();
  }
  return file_trouble_.empty();
}

bool RecordingWriter::begin(Duration start) {
  return on_file([&] {
    if (std::exchange(began_, true)) return;
    file_.begin();
    header_.write(file_, start);
  });
}

void RecordingWriter::push(Batch&& batch) {
  MUROSIMF_ASSERT(began_ && frames_);
  thread_->push(std::move(batch));
}

/// In the thread.
void RecordingWriter::write(const Batch& batch) {
  const std::lock_guard lock(writing_);
  for (const RecordedFrame& frame : batch) {
    frames_->write(frame);
    pictures_->write(frame);
    drawings_->write(frame);
  }
  const auto now = std::chrono::steady_clock::now();
  if (now - synced_ < std::chrono::seconds(1)) return;
  file_.sync();  // what a loss of power leaves, at most a second old
  synced_ = now;
}

void RecordingWriter::finish(const scene::RunReport& report) {
  thread_->finish();
  (void)on_file([&] {
    header_.write_end(file_, report);
    file_.close();
  });
}

std::string RecordingWriter::trouble() const {
  const std::string trouble = thread_->trouble();
  return trouble.empty() ? file_trouble_ : trouble;
}

}  // namespace murosimf::recording
