#include "murosimf/runtime/pose_feed.h"

#include <utility>

namespace murosimf {

const PoseFrame* PoseReader::latest() noexcept {
  if ((complete_.load(std::memory_order_acquire) & is_new) == 0) return nullptr;
  read_ = complete_.exchange(read_, std::memory_order_acq_rel) & ~is_new;
  return &frames_[read_];
}

bool PoseReader::wants(Duration now) const noexcept {
  return !any_ || now < last_ || now - last_ >= request_.period;  // a reset goes back in time
}

void PoseReader::publish() noexcept {
  written_ = complete_.exchange(written_ | is_new, std::memory_order_acq_rel) & ~is_new;
}

std::shared_ptr<PoseReader> PoseFeed::subscribe(const PoseRequest& request) {
  auto reader = std::make_shared<PoseReader>(request);
  const std::lock_guard lock(mutex_);
  readers_.push_back(reader);
  anybody_.store(true, std::memory_order_relaxed);
  return reader;
}

void PoseFeed::take(const World& world, Duration now, std::int64_t tick, PoseFrame& frame) const {
  take_poses(world, frame);
  if (completion_) completion_(world, frame);
  frame.time = now;
  frame.tick = tick;
  frame.contacts.clear();
}

void PoseFeed::publish_to_all(const World& world, Duration now, std::int64_t tick, bool again) {
  const std::lock_guard lock(mutex_);
  std::erase_if(readers_, [](const auto& reader) { return reader.expired(); });
  anybody_.store(!readers_.empty(), std::memory_order_relaxed);
  for (const auto& weak : readers_) {
    const auto reader = weak.lock();
    if (!reader || (!again && !reader->wants(now))) continue;
    PoseFrame& frame = reader->frames_[reader->written_];
    take_poses(world, frame);
    if (again && completion_) completion_(world, frame);
    frame.time = now;
    frame.tick = tick;
    frame.contacts.clear();
    if (reader->request_.contacts && contacts_) contacts_(world, frame.contacts);
    reader->any_ = true;
    reader->last_ = now;
    reader->publish();
  }
}

}  // namespace murosimf
