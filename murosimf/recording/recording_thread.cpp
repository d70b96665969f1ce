#include "murosimf/recording/recording_thread.h"

#include <exception>
#include <utility>

#include "murosimf/math/assert.h"

namespace murosimf::recording {

RecordingThread::RecordingThread(std::function<void(const Batch&)> write)
    : write_(std::move(write)), thread_([this] { run(); }) {}

RecordingThread::~RecordingThread() { finish(); }

void RecordingThread::push(Batch&& batch) {
  std::size_t waiting = 0;
  {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return waiting_.size() < most_waiting; });
    waiting_.push_back(std::move(batch));
    MUROSIMF_ASSERT(waiting_.size() <= most_waiting);
    waiting = waiting_.size();
  }
  if (waiting >= worth_waking) changed_.notify_all();  // after unlocking, so that the woken thread finds the mutex free
}

RecordingThread::Batch RecordingThread::spent() {
  const std::lock_guard lock(mutex_);
  return std::exchange(spent_, {});
}

/// Everything that was given is written before the thread ends.
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
    if (waiting_.empty()) changed_.wait(lock, [this] { return ends_ || waiting_.size() >= worth_waking; });
    if (waiting_.empty()) return;
    Batch batch = std::move(waiting_.front());
    // written without the lock: the simulation continues to queue meanwhile
    waiting_.pop_front();
    const bool good = trouble_.empty();
    lock.unlock();
    changed_.notify_all();
    if (good) write(batch);
    lock.lock();
    spent_ = std::move(batch);
  }
}

/// An error ends the recording, not the simulation; its reason is kept.
void RecordingThread::write(const Batch& batch) {
  try {
    write_(batch);
  } catch (const std::exception& error) {
    const std::lock_guard lock(mutex_);
    trouble_ = error.what();
  }
}

}  // namespace murosimf::recording
