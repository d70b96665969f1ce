/// recording_thread.h - writes recorded data in a separate thread.
///
/// At most `most_waiting` batches are queued. With a full queue push() waits: nothing is ever dropped,
/// and a simulation at full speed is slowed down to the speed of the disk. The thread is woken when two
/// batches are queued: waking it takes the simulation longer than copying a batch.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "murosimf/recording/recorded_frame.h"

namespace murosimf::recording {

class RecordingThread {
 public:
  using Batch = std::vector<RecordedFrame>;

  /// `write` is called in the thread. After it has thrown a SetupError, all further batches are discarded.
  explicit RecordingThread(std::function<void(const Batch&)> write);
  ~RecordingThread();
  RecordingThread(const RecordingThread&) = delete;
  RecordingThread& operator=(const RecordingThread&) = delete;

  void push(Batch&& batch);
  /// A written batch, for reuse of its memory, which is still in the caches; empty if there is none.
  [[nodiscard]] Batch spent();
  /// Waits until everything is written.
  void finish();
  /// The error, if any; empty: none.
  [[nodiscard]] std::string trouble() const;

  static constexpr std::size_t most_waiting = 3;
  static constexpr std::size_t worth_waking = 2;

 private:
  void run();
  void write(const Batch& batch);

  std::function<void(const Batch&)> write_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Batch> waiting_;
  Batch spent_;
  bool ends_ = false;
  std::string trouble_;
  std::thread thread_;
};

}  // namespace murosimf::recording
