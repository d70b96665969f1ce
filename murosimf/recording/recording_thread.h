/// recording_thread.h - writes what is recorded in a thread of its own.
///
/// At most `most_waiting` batches wait for it. When there are as many, who brings one more waits until there is room: nothing is ever
/// left out, and a simulation that runs as fast as it can is slowed down to what the disk takes. The thread is woken when two
/// wait: waking it takes the simulation longer than to copy what a batch has.
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

  /// `write` is called in the thread. Once it has thrown a SetupError, all batches to come are thrown away.
  explicit RecordingThread(std::function<void(const Batch&)> write);
  ~RecordingThread();
  RecordingThread(const RecordingThread&) = delete;
  RecordingThread& operator=(const RecordingThread&) = delete;

  void push(Batch&& batch);
  /// One that was written, for who fills the next one in its memory, which caches still know; empty if there is none.
  [[nodiscard]] Batch spent();
  /// Waits until all is written.
  void finish();
  /// What has gone wrong; empty: nothing.
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
