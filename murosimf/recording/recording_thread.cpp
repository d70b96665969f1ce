#include "murosimf/recording/recording_thread.h"

#include <exception>
#include <utility>

namespace murosimf::recording {

RecordingThread::RecordingThread(std::function<void(const Batch&)> write)
    : write_(std::move(write)), thread_([this] { run(); }) {}

RecordingThread::~RecordingThread() { finish(); }

void RecordingThread::push(Batch&& batch) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return waiting_.size() < most_waiting; });
  waiting_.push_back(std::move(batch));
  changed_.notify_all();
}

void RecordingThread::finish() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
    changed_.notify_all();
  }
  if (thread_.joinable()) thread_.join();
}

std::string RecordingThread::trouble() const {
  const std::lock_guard lock(mutex_);
  return trouble_;
}

void RecordingThread::run() {
  for (;;) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return ends_ || !waiting_.empty(); });
    if (waiting_.empty()) return;
    const Batch batch = std::move(waiting_.front());
    waiting_.pop_front();
    changed_.notify_all();
    const bool good = trouble_.empty();
    lock.unlock();
    if (good) write(batch);
  }
}

void RecordingThread::write(const Batch& batch) {
  try {
    write_(batch);
  } catch (const std::exception& error) {
    const std::lock_guard lock(mutex_);
    trouble_ = error.what();
  }
}

}  // namespace murosimf::recording
