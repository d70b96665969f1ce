/// pose_feed.h - hands copies of the poses from the simulation to readers in other threads; neither waits for the other.
///
///     auto reader = simulation.poses().subscribe({.period = 20ms, .contacts = true});     // in any thread, at any time
///     if (const PoseFrame* frame = reader->latest()) draw(*frame);                         // in one thread
///
/// Every reader has three frames: one that it looks at, one that is written, and the last complete one, which change places.
/// Without subscribers nothing is copied, and a tick costs one test.
#pragma once

#include <array>
#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

#include "murosimf/runtime/pose_frame.h"

namespace murosimf {

struct PoseRequest {
  Duration period{};      ///< of simulated time between two frames at least; 0: one after every step
  bool contacts = false;  ///< also where things touch
};

/// A subscriber. It unsubscribes when it is destroyed.
class PoseReader {
 public:
  explicit PoseReader(const PoseRequest& request) : request_(request) {}

  /// The newest frame since the last call, which stays as it is until the next call; null if there is no newer one. One thread.
  [[nodiscard]] const PoseFrame* latest() noexcept;

 private:
  friend class PoseFeed;
  [[nodiscard]] bool wants(Duration now) const noexcept;
  void publish() noexcept;  ///< the written frame becomes the last complete one

  static constexpr unsigned is_new = 4;  // beside the number of the frame

  PoseRequest request_;
  std::array<PoseFrame, 3> frames_;
  unsigned written_ = 0, read_ = 1;    // of the simulation's thread, of the reader's
  std::atomic<unsigned> complete_{2};  // of no subscriber
  bool any_ = false;                   // of the simulation's thread
  Duration last_{};
};

class PoseFeed {
 public:
  /// From any thread, at any time.
  [[nodiscard]] std::shared_ptr<PoseReader> subscribe(const PoseRequest& request = {});

  /// Where frames get their contacts from; none: they have none.
  void contacts_from(ContactSource source) { contacts_ = std::move(source); }

  /// What frames have of contacts. The simulation's thread, between two steps.
  void add_contacts(const World& world, std::vector<ContactMark>& contacts) const {
    if (contacts_) contacts_(world, contacts);
  }

  /// A frame for a caller without subscription, without contacts; allocates only if it is too small. The simulation's thread, between
  /// two steps.
  void take(const World& world, Duration now, std::int64_t tick, PoseFrame& frame) const;

  /// How frames are completed that are taken between two steps, after columns have been changed; none: as columns are.
  void complete_by(FrameCompletion completion) { completion_ = std::move(completion); }

  /// The simulation's thread, between two steps.
  void publish(const World& world, Duration now, std::int64_t tick) {
    if (anybody_.load(std::memory_order_relaxed)) publish_to_all(world, now, tick, false);
  }
  /// The same for all readers, whatever their period; with what was changed since the last step.
  void publish_again(const World& world, Duration now, std::int64_t tick) {
    if (anybody_.load(std::memory_order_relaxed)) publish_to_all(world, now, tick, true);
  }

 private:
  void publish_to_all(const World& world, Duration now, std::int64_t tick, bool again);

  std::mutex mutex_;  // of the list
  std::vector<std::weak_ptr<PoseReader>> readers_;
  std::atomic<bool> anybody_{false};
  ContactSource contacts_;
  FrameCompletion completion_;
};

}  // namespace murosimf
