/// thread_pool.h - a fixed pool of threads that runs the algorithms of one wave.
///
/// Every thread begins with its own share of a wave; a thread that has finished helps the others. Shares that are alike from wave to wave
/// leave what the algorithms of an entity touch in the caches of one thread. Algorithms of a wave never touch what another of them
/// writes, so the result cannot depend on the assignment to threads or on their number. The calling thread takes part and never waits
/// for a thread that has not begun. What has begun it must wait for, also while another program has that thread's core: so waves are
/// shared out only as long as that pays (worth_sharing.h), and otherwise the calling thread makes them alone while the others sleep.
#pragma once

#include <atomic>
#include <cstdint>
#include <span>
#include <thread>
#include <type_traits>
#include <vector>

#include "murosimf/runtime/worth_sharing.h"

namespace murosimf {

/// Which waves are shared out among the threads of a pool.
enum class Sharing {
  if_it_pays,  ///< as long as they take less time than one thread alone; only time depends on it
  always,      ///< for tests, and items that wait for each other
};

/// if_it_pays, or always if the variable MUROSIMF_SHARE_WAVES of the environment says `always`: for tests, which are to see races.
[[nodiscard]] Sharing usual_sharing();

class ThreadPool {
 public:
  /// `threads` counts the calling thread too; at least 1. Throws SetupError if the system does
  /// not give so many.
  explicit ThreadPool(int threads, Sharing sharing = usual_sharing(), WorthSharing worth = WorthSharing());
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  [[nodiscard]] int threads() const { return static_cast<int>(workers_.size()) + 1; }
  /// From the next wave on.
  void share(Sharing sharing) { sharing_ = sharing; }
  /// How many waves so far had something for several threads, and how many of these were shared out.
  [[nodiscard]] std::uint64_t waves() const { return waves_with_company_; }
  [[nodiscard]] std::uint64_t waves_shared() const { return waves_shared_; }

  /// Whether a wave that comes now would be shared out; if not, the caller may cut it into other items and call alone().
  [[nodiscard]] bool shares() const { return !workers_.empty() && (sharing_ == Sharing::always || worth_.shares()); }

  /// Calls `run(i)` for every item i and returns when all are done. `run` must not throw. The share of thread t, 0 for the calling
  /// one, is [ends[t - 1], ends[t]), from 0 on; `ends` has an entry for every thread. `kind`: as for WorthSharing.
  template <class Run>
  void for_each(std::span<const std::size_t> ends, std::uint64_t kind, Run&& run) {
    if (!for_several(ends)) {
      for (std::size_t i = 0; i < ends.back(); ++i) run(i);
    } else if (begin_wave()) {
      share_out(
          ends, [](void* context, std::size_t i) { (*static_cast<std::remove_reference_t<Run>*>(context))(i); }, &run);
      end_wave(kind);
    } else {
      for (std::size_t i = 0; i < ends.back(); ++i) run(i);
      end_wave(kind);
    }
  }
  /// The same for `count` items in even shares.
  template <class Run>
  void for_each(std::size_t count, Run&& run) {
    const auto threads = static_cast<std::size_t>(this->threads());
    even_ends_.resize(threads);
    for (std::size_t t = 0; t < threads; ++t) even_ends_[t] = (t + 1) * count / threads;
    for_each(std::span<const std::size_t>(even_ends_), count, run);
  }
  /// Instead of for_each with these ends, while !shares(): calls `run()`, which makes the whole wave, in the calling thread.
  template <class Run>
  void alone(std::span<const std::size_t> ends, std::uint64_t kind, Run&& run) {
    if (!for_several(ends)) return run();
    (void)begin_wave();
    run();
    end_wave(kind);
  }

 private:
  using Call = void (*)(void* context, std::size_t i);

  /// What is left of a thread's share, in a cache line of its own.
  struct alignas(64) Share {
    // Generation of the wave in the upper half, items that are not taken yet in the lower one. Taking an item keeps the wave from
    // ending, so a thread that has taken one may read the others.
    std::atomic<std::uint64_t> open{0};
    std::size_t first = 0;
    Call call = nullptr;
    void* context = nullptr;
  };

  /// Not if others have nothing to do, or one item is not worth telling them.
  [[nodiscard]] bool for_several(std::span<const std::size_t> ends) const {
    return !workers_.empty() && ends.front() != ends.back() && ends.back() != 1;
  }
  /// Whether to share it out.
  [[nodiscard]] bool begin_wave() {
    ++waves_with_company_;
    return sharing_ == Sharing::always || worth_.begin_wave();
  }
  void end_wave(std::uint64_t kind) {
    if (sharing_ == Sharing::if_it_pays) worth_.end_wave(kind);
  }
  void share_out(std::span<const std::size_t> ends, Call call, void* context);
  /// Until nothing is left. False if that is so already.
  bool run_share(Share& share);
  /// Takes one item and runs it; false if none is left.
  static bool run_one(Share& share);
  /// Takes items of other shares that are not begun, after the own share.
  void help();
  void work(Share& own);
  void stop();  ///< ends all threads that have begun

  Sharing sharing_;
  WorthSharing worth_;
  std::uint64_t waves_with_company_ = 0, waves_shared_ = 0;
  std::vector<std::size_t> even_ends_;
  std::vector<Share> shares_;  // by thread
  alignas(64) std::atomic<std::uint64_t> unfinished_{0};
  alignas(64) std::atomic<std::uint32_t> waves_{0};  // so far; sleeping threads wait for the next
  std::atomic<bool> stop_{false};
  std::vector<std::thread> workers_;
};

}  // namespace murosimf
