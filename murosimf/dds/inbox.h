/// inbox.h - messages that have arrived over DDS, on threads of its own, until the simulation takes them at its next step.
#pragma once

#include <array>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

#include "murosimf/dds/cdr.h"

namespace murosimf::dds {

/// Which message of which writer, as RTPS numbers them: answers are addressed to it.
struct SampleIdentity {
  std::array<std::uint8_t, 16> writer{};  ///< GUID; its first two bytes are the vendor of the DDS
  std::int64_t number = 0;                ///< from 1 on
};

struct Arrival {
  char topic = 0;  ///< chosen by the owner of the inbox
  Bytes message;
  SampleIdentity from{};
  SampleIdentity request{};  ///< of an answer: that it answers
};

class Inbox {
 public:
  static constexpr std::size_t most_messages = 1000, longest_message = 65000;  ///< [1], [byte]; what is beyond is lost

  void put(char topic, std::span<const std::uint8_t> message, const SampleIdentity& from = {},
           const SampleIdentity& request = {}) {
    const std::lock_guard lock(mutex_);
    if (arrived_.size() >= most_messages || message.size() > longest_message) {
      ++lost_;
    } else {
      arrived_.push_back({topic, {message.begin(), message.end()}, from, request});
    }
    news_.notify_one();
  }
  /// A program that writes has come (1), or has gone (-1).
  void count_writer(int change) {
    const std::lock_guard lock(mutex_);
    writers_ += change;
    news_.notify_one();
  }
  /// In the order in which they came.
  [[nodiscard]] std::vector<Arrival> take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(arrived_, {});
  }
  /// [1] of all its topics together.
  [[nodiscard]] int writers() {
    const std::lock_guard lock(mutex_);
    return writers_;
  }
  [[nodiscard]] std::uint64_t lost() {
    const std::lock_guard lock(mutex_);
    return lost_;
  }
  /// Waits for any message.
  void wait(std::chrono::nanoseconds longest) {
    std::unique_lock lock(mutex_);
    (void)news_.wait_for(lock, longest, [&] { return !arrived_.empty(); });
  }
  /// Waits for a message of this topic, as long as a program writes. False: the time is over.
  [[nodiscard]] bool wait_for(char topic, std::chrono::nanoseconds longest) {
    std::unique_lock lock(mutex_);
    const auto there = [&] {
      for (const Arrival& arrival : arrived_) {
        if (arrival.topic == topic) return true;
      }
      return writers_ == 0;
    };
    return news_.wait_for(lock, longest, there);
  }

 private:
  std::mutex mutex_;
  std::condition_variable news_;
  std::vector<Arrival> arrived_;
  int writers_ = 0;
  std::uint64_t lost_ = 0;
};

}  // namespace murosimf::dds
