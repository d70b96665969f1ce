/// recording_writer.h - writes frames into an MCAP file, in a thread of its own (recording_thread.h).
///
/// It owns the file, and what has gone wrong with it: after the first error nothing more is written.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <string>

#include "murosimf/recording/frame_writer.h"
#include "murosimf/recording/mcap/mcap_writer.h"
#include "murosimf/recording/recorded_drawings.h"
#include "murosimf/recording/recorded_picture.h"
#include "murosimf/recording/recording_capture.h"
#include "murosimf/recording/recording_header.h"
#include "murosimf/recording/recording_thread.h"
#include "murosimf/recording/scene_message.h"

namespace murosimf::recording {

class RecordingWriter {
 public:
  using Batch = RecordingThread::Batch;

  /// The header outlives it. Throws SetupError for a file that cannot be written, or that another run writes.
  RecordingWriter(const std::filesystem::path& file, const std::string& library, RecordingHeader& header);

  /// Of what frames are made; all of it outlives the writer. Before the first push().
  void open_channels(const scene::Scene& scene, const RecordingCapture& capture);
  /// When robots or bodies have come to the scene: `meet` makes the lists of `capture` and the header longer, which no frame is written meanwhile.
  void meet_newcomers(const scene::Scene& scene, const RecordingCapture& capture, const std::function<void()>& meet);
  [[nodiscard]] bool has_channels() const noexcept { return frames_ != nullptr; }

  /// Begins the file, once: with what stands before its first frame, which is of the time `start`. Whether nothing is wrong.
  bool begin(Duration start);
  [[nodiscard]] bool began() const noexcept { return began_; }
  /// Waits while too much is on its way.
  void push(Batch&& batch);
  /// One that was written, for its memory.
  [[nodiscard]] Batch spent() { return thread_->spent(); }
  /// Writes all that is on its way, then the end of the file.
  void finish(const scene::RunReport& report);

  /// Why nothing is written any more, in one line; empty: all is well.
  [[nodiscard]] std::string trouble() const;
  [[nodiscard]] const GrowingFile& file() const noexcept { return file_.file(); }

 private:
  template <class Call>
  bool on_file(const Call& call);
  void write(const Batch& batch);

  McapWriter file_;
  RecordingHeader& header_;
  std::unique_ptr<SceneLooks> looks_;
  std::unique_ptr<FrameWriter> frames_;
  std::unique_ptr<PictureWriter> pictures_;
  std::unique_ptr<DrawingWriter> drawings_;
  bool began_ = false;
  std::mutex writing_;                              // a batch, or a longer list of what batches are made of
  std::string file_trouble_;                        // besides that of the thread
  std::chrono::steady_clock::time_point synced_{};  // the thread's
  std::unique_ptr<RecordingThread> thread_;         // last: it uses all of the above
};

}  // namespace murosimf::recording
