/// thread_pool.h - a fixed pool of threads that runs the algorithms of one wave.
///
/// Every thread begins with its own share of a wave; who has done that helps the others. Shares that are alike from wave to wave
/// leave what the algorithms of an entity touch in the caches of one thread. Algorithms of a wave never touch what another of them
/// writes, so the result cannot depend on who takes what or on the number of threads. The calling thread takes part and never waits
/// for a thread that has not begun: on a busy machine the pool is no slower than one thread.
#pragma once

#include <atomic>
#include <cstdint>
#include <span>
#include <thread>
#include <type_traits>
#include <vector>

namespace murosimf {

class ThreadPool {
 public:
  /// `threads` counts the calling thread too; at least 1. Throws SetupError if the system does not give so many.
  explicit ThreadPool(int threads);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  [[nodiscard]] int threads() const { return static_cast<int>(workers_.size()) + 1; }

  /// Calls `run(i)` for every item i and returns when all are done. `run` must not throw. The share of thread t, 0 for the calling
  /// one, is [ends[t - 1], ends[t]), from 0 on; `ends` has an entry for every thread.
  template <class Run>
  void for_each(std::span<const std::size_t> ends, Run&& run) {
    if (ends.front() == ends.back() || ends.back() == 1) {  // nothing for the others, or not worth telling them
      for (std::size_t i = 0; i < ends.back(); ++i) run(i);
      return;
    }
    dispatch(
        ends, [](void* context, std::size_t i) { (*static_cast<std::remove_reference_t<Run>*>(context))(i); }, &run);
  }
  /// The same for `count` items in even shares.
  template <class Run>
  void for_each(std::size_t count, Run&& run) {
    const auto threads = static_cast<std::size_t>(this->threads());
    std::vector<std::size_t> ends(threads);
    for (std::size_t t = 0; t < threads; ++t) ends[t] = (t + 1) * count / threads;
    for_each(std::span<const std::size_t>(ends), run);
  }

 private:
  using Call = void (*)(void* context, std::size_t i);

  /// What is left of a thread's share, in a cache line of its own.
  struct alignas(64) Share {
    // Generation of the wave in the upper half, items that nobody has taken in the lower one. Taking an item keeps the wave from
    // ending, so whoever took one may read the others.
    std::atomic<std::uint64_t> open{0};
    std::size_t first = 0;
    Call call = nullptr;
    void* context = nullptr;
  };

  void dispatch(std::span<const std::size_t> ends, Call call, void* context);
  /// Until nothing is left. False if that is so already.
  bool run_share(Share& share);
  /// Takes one item and runs it; false if none is left.
  static bool run_one(Share& share);
  /// Who has done its own share: what others have not begun.
  void help();
  void work(Share& own);
  void stop();  ///< ends all threads that have begun

  std::vector<Share> shares_;  // by thread
  alignas(64) std::atomic<std::uint64_t> unfinished_{0};
  alignas(64) std::atomic<std::uint32_t> waves_{0};  // so far; who sleeps waits for the next
  std::atomic<bool> stop_{false};
  std::vector<std::thread> workers_;
};

}  // namespace murosimf
